# The environment is made in .venv by whichever target runs first; PYTHON chooses the interpreter it is made from.
PYTHON ?= python3
VENV := .venv
BIN := $(VENV)/bin
READY := $(VENV)/.ready
PROBLEM ?= problems/course/ch1/ch1-ex02.yaml
TESTS ?=
SAMPLE ?= 60
LEAST ?= 0.9
WORKERS ?= auto
# Tests start many processes, each of which would compile the program and its templates anew.
unexport PYTHONDONTWRITEBYTECODE

.DEFAULT_GOAL := help
.PHONY: help solve test test-all test-whole mutants corrupted lint bench guides errata tables task clean

help:  ## Say what there is to make.
	@grep -E '^[a-z-]+:.*##' $(MAKEFILE_LIST) | sed -E 's/:[^#]*## /\t/' | expand -t 10

$(READY): pyproject.toml
	@$(PYTHON) -c 'import sys; sys.exit(sys.version_info < (3, 11))' || \
		{ echo "Python 3.11 or newer is needed; name one: make PYTHON=python3.12 ..."; exit 1; }
	test -x $(BIN)/python || $(PYTHON) -m venv $(VENV)
	$(BIN)/python -m pip install --quiet --editable '.[dev]'
	touch $@

solve: $(READY)  ## Solve a problem of the course (PROBLEM=path for another) and say where its page is.
	@mkdir -p build
	@$(BIN)/solve $(PROBLEM) -o build/
	@echo "The page: $(abspath build)/$(basename $(notdir $(PROBLEM))).html"

test: $(READY)  ## Run the quick tests (TESTS="-k pattern" or paths for some of them).
	$(BIN)/python -m pytest -n $(WORKERS) --dist loadgroup -m "not slow" $(TESTS)

test-all: $(READY)  ## Run the slow tests too: cross-checks, more generated examples, sweeps of which a share is in turn.
	$(BIN)/python -m pytest -n $(WORKERS) --dist loadgroup --hypothesis-profile third -m "not whole" $(TESTS)

test-whole: $(READY)  ## Run all tests whole: sweeps over all problems and views, all generated examples.
	WHOLE=1 $(BIN)/python -m pytest -n $(WORKERS) --dist loadgroup --hypothesis-profile all $(TESTS)

mutants: $(READY)  ## Make small slips in the program and say which of them no test sees (SAMPLE of them).
	$(BIN)/python -m tools.mutants --sample $(SAMPLE) --least $(LEAST)

corrupted: $(READY)  ## Make the results of kernels a little wrong and say which of them reach a verified page.
	$(BIN)/python -m tools.corrupted_kernels

lint: $(READY)  ## Check style, types, who imports whom, and calls that are forbidden.
	$(BIN)/ruff check
	$(BIN)/ruff format --check
	$(BIN)/mypy
	$(BIN)/lint-imports
	$(BIN)/python tools/forbidden_calls.py solver

bench: $(READY)  ## Print the table of speed targets beside their peers (python -m benchmarks --help names the groups).
	$(BIN)/python -m benchmarks

guides: $(READY)  ## Follow the guides of a first hour in an empty folder; `!` stands before what they tell otherwise.
	$(BIN)/python -m tools.guides

errata: $(READY)  ## Mark what the lecture note prints, and list in docs/errata.md what is wrong.
	$(BIN)/python tools/errata.py

tables: $(READY)  ## Write what the tasks declare into docs/user-guide.md, docs/tasks.md and docs/methods.md.
	$(BIN)/python -m tools.tables

task: $(READY)  ## Write the files of a new task that run as they are (NAME=steady_state_error TOPIC=classical).
	$(BIN)/python tools/new_task.py $(NAME) $(TOPIC)
	$(BIN)/python -m tools.tables

clean:  ## Remove what was made, but not the environment.
	rm -rf build dist .pytest_cache .mypy_cache .ruff_cache .hypothesis .import_linter_cache
	find solver tests benchmarks tools -name __pycache__ -type d -prune -exec rm -rf {} +
