"""Puts the pages of the site together: those of docs/ and those made from the code.

Run as `python -m experiments.docs_tools.site FOLDER`; `make docs` does so, and lets
Sphinx build the site from FOLDER.
"""

import sys
from pathlib import Path

from experiments.docs_tools.site.assembly import assemble

if __name__ == "__main__":
    assemble(Path.cwd(), Path(sys.argv[1]))
