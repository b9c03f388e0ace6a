# Two commands for everyone: `make reproduce` and `make test`. Each target sets up .venv.
PYTHON ?= python3
SEEDS ?= 30
OUT ?= runs/paper
BIN := .venv/bin

# Runs a command that may say nothing for long; a point every two seconds says it works.
define patiently
@(while sleep 2 && kill -0 $$$$ 2>/dev/null; do printf .; done) & \
  $(1); status=$$?; kill $$!; exit $$status
endef

.PHONY: reproduce test docs clusters oldest lint slow golden clean

reproduce: .venv/rendering
	$(BIN)/household reproduce --seeds $(SEEDS) --out $(OUT)

# On all cores, up to eight; a file's tests share what they set up, so they stay together.
# The order is that of tests/conftest.py.
test: .venv/developing
	$(BIN)/pytest --numprocesses logical --maxprocesses 8 --dist loadfile \
	  --no-loadscope-reorder

# The site in build/docs/html, from docs/, docstrings and the code; a warning is an error.
docs: .venv/documenting
	$(BIN)/python -m experiments.docs_tools.site build/docs/source
	$(BIN)/sphinx-build -q -W --keep-going -j auto build/docs/source build/docs/html
	@echo "build/docs/html/index.html"

# Trials on Dask and on Ray; `make test` leaves Ray out, which is 250 MB.
clusters: .venv/developing
	$(BIN)/pip install --quiet --disable-pip-version-check --editable '.[dask,ray]'
	$(BIN)/pytest tests/experiments/running/engine/test_clusters.py

# A little of everything with the oldest versions of all dependencies that are allowed,
# in an environment of its own; the package is installed, so that it compiles for itself.
oldest:
	rm -rf build/oldest
	$(PYTHON) -m venv build/oldest
	build/oldest/bin/pip install --quiet --disable-pip-version-check \
	  --requirement tests/oldest.txt pytest
	build/oldest/bin/pip install --quiet --disable-pip-version-check --no-deps .
	build/oldest/bin/pytest -W ignore tests/test_smoke.py

slow: .venv/developing
	$(BIN)/pytest -m slow

# Renews what histories, learners, portraits of people, references and the programs of
# pages come to, when behavior has changed on purpose; takes some minutes.
golden: .venv/developing
	$(BIN)/python -m tests.golden
	$(BIN)/python -m experiments.docs_tools.portraits docs/people.md
	$(BIN)/python -m experiments.docs_tools.home_scores docs/scores/scenarios.json
	$(BIN)/python -m experiments.docs_tools.outputs README.md docs/tutorials/*.md

lint: .venv/developing
	$(BIN)/ruff check .
	$(BIN)/ruff format --check .
	$(BIN)/mypy
	$(BIN)/lint-imports
	$(BIN)/codespell

.venv/bin/python:
	$(PYTHON) -c 'import sys; sys.exit(sys.version_info < (3, 11) and "needs Python 3.11 or newer: make PYTHON=python3.11")'
	$(call patiently,$(PYTHON) -m venv .venv)

.venv/installed: pyproject.toml | .venv/bin/python
	$(BIN)/pip install --quiet --disable-pip-version-check --editable .
	touch $@

# With what films of the typical trials need; pip says what it does.
.venv/rendering: pyproject.toml | .venv/bin/python
	@echo "Installing household and what it needs into .venv; some minutes, once"
	$(call patiently,$(BIN)/pip install --disable-pip-version-check --editable '.[render]')
	touch $@ .venv/installed

.venv/developing: pyproject.toml | .venv/bin/python
	$(BIN)/pip install --quiet --disable-pip-version-check --editable '.[dev]'
	touch $@ .venv/installed

.venv/documenting: pyproject.toml | .venv/bin/python
	$(BIN)/pip install --quiet --disable-pip-version-check --editable '.[docs]'
	touch $@ .venv/installed

clean:
	rm -rf .venv build dist
