"""`python -m experiments` is the command `household`."""

import sys

from experiments.cli import main

sys.exit(main())
