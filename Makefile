# make         run the campaigns in samples/ and campaigns/ that have changed, on all cores, and list how each ended
# make CAMPAIGNS="FOLDER ..." the same of other folders: campaigns, folders of campaigns, or lists, whose names hold no blanks
# make report  write their reports again from the documents in out/
# make compare CAMPAIGNS="FOLDER ..." compare campaigns of one robot, the oldest first
# make clean-NAME remove the output of campaign NAME; make clean that of all
# make test    run the tests but the long laws
# make laws    the laws that take minutes: intervals that hold, powers, mutants, by thousands of simulated campaigns
# make quick   the tests of single files, of the architecture and of golden documents, and the examples of the documentation: before each commit
# make unit CRATE=NAME those of one crate, some seconds after an edit; T=NAME only those whose path holds NAME
# make attack  set the program under random attacks for ten minutes, by a seed that is printed: damaged files and bytes, kills, commands at once,
#              hostile names, links, mutants of campaigns, drawn tables, archives, templates and values of the environment; SEED= repeats one,
#              ATTACK= states another time in seconds, DRAWS= the most drawn files (10,000), ETALON_PROGRAM= another build
# make bench   compare with SciPy, NumPy and Pinocchio, side by side in the same run, and write benches/README.md; COUNT= sets how many campaigns
# make bench-fit compare the fits of elements with engeom, Ceres and SciPy (builds engeom: ten minutes and more the first time)
# make bench-import read ten million points beside polars and pandas (installs them beside the build)
# make bench-python calls from Python beside the library, after `make python`
# make thesis  the tables and figures of the thesis, printed and computed side by side: target/thesis/thesis.html and thesis.md
# make test-slurm run campaigns on a Slurm cluster of two nodes on this machine, and kill one (needs root, slurm-wlm and munge)
# make test-linuxcnc load exported kinematics into LinuxCNC and compare its joint positions (needs root; installs linuxcnc-uspace of Debian)
# make real    download public campaigns of real robots, run them, and print etalon's figures beside the published ones;
#              REAL_SOURCE=FOLDER takes the files from a folder instead
# make benchmark calibrate published sets of real robots with etalon, SciPy and FIGAROH, score predicted test poses, and write docs/benchmark.md;
#              REAL_SOURCE=FOLDER takes the files from a folder; SETS="NAME ..." takes some sets and writes no page
# make reference write an archive of the reference campaigns with certified values: target/reference
# make python  build the wheel with the Python module and the program, and test it in a virtual environment beside the build
# make figures draw the figures of docs/ again from numbers of the program (needs python3)
# make book    make a book of docs/ with mdBook, without a dead link: target/book/index.html
# make dist    write an archive, a Debian package, a list of components and checksums of the program: target/dist;
#              TARGETS="x86_64-unknown-linux-musl ..." adds archives for other systems
# make samples make the synthetic samples again from their truth
# make help    this text
SHELL := /bin/bash
.SHELLFLAGS := -euo pipefail -c
MAKEFLAGS += --no-builtin-rules --warn-undefined-variables
.SUFFIXES:
.DELETE_ON_ERROR:
.DEFAULT_GOAL := all

CARGO_TARGET_DIR ?= target
# make PROFILE=dev builds a program that is not optimised
PROFILE ?= release
ETALON := $(CARGO_TARGET_DIR)/$(PROFILE:dev=debug)/etalon
SOURCES := Cargo.toml Cargo.lock $(shell find src -type f)
TARGETS ?=
T ?=
CRATE ?=
CAMPAIGNS ?=

SHARED := $(abspath $(CARGO_TARGET_DIR))/bench-fit

.PHONY: all report compare test laws quick unit attack test-slurm test-linuxcnc real benchmark reference thesis bench bench-fit bench-import bench-python samples python figures book dist help clean

# names of folders are never a part of a rule, and reach the shell as they are: from its own patterns, or quoted
unexport CAMPAIGNS
NAMED := $(foreach name,$(value CAMPAIGNS),'$(subst ','\'',$(name))')
EACH := $(if $(NAMED),$(NAMED),samples/*/ campaigns/*/)

# batch.parquet and batch.html of `make`
RESULTS := $(abspath $(CARGO_TARGET_DIR))/campaigns

# a campaign that fails stops no other
all: $(ETALON)
	@$(ETALON) batch --newer-than $(ETALON) --to $(RESULTS) -- $(if $(NAMED),$(NAMED),$(wildcard samples campaigns))

$(ETALON): $(SOURCES)
	cargo build --profile $(PROFILE) --locked

report: $(ETALON)
	@for c in $(EACH); do [ ! -f "$$c/out/manifest.json" ] || $(ETALON) report -- "$$c/out" || exit; done

compare: $(ETALON)
	$(ETALON) compare -- $(EACH)

# the libraries are built once, as the program has them; etalon's own crates are not optimised for the tests of single files, but for those that
# compute for seconds
COMPUTING := etalon-math etalon-fit etalon-robots etalon-identify
CRATES := $(patsubst src/%/Cargo.toml,etalon-%,$(wildcard src/*/Cargo.toml)) etalon
UNOPTIMISED := $(foreach crate,$(CRATES),$(foreach option,opt-level=$(if $(filter $(crate),$(COMPUTING)),1,0) debug-assertions=true codegen-units=256,--config profile.release.package.$(crate).$(option)))
NEXTEST := $(shell command -v cargo-nextest)
RUN := cargo $(if $(NEXTEST),nextest run,test) --locked --release
WHOLE := $(RUN) --test laws --test etalon
# a test that fails stops no other
KEEP := --no-fail-fast
# tests of single files derive the schemas from the types; the program contains those of schemas/
DERIVED := --features schemas
SINGLE := env CARGO_INCREMENTAL=1 $(RUN) $(UNOPTIMISED)
# examples of the documentation: nextest runs none
EXAMPLES := env CARGO_INCREMENTAL=1 cargo test --locked --release $(UNOPTIMISED) --doc --workspace $(DERIVED)

test:
	[ -n "$${ETALON_REFERENCE:-}" ] || echo "ETALON_REFERENCE is not set: tests on outside data (NIST, PreXYT, IRB 120) are skipped"
	$(WHOLE) --no-run
	@# those of single files are compiled while the others run, which hold the folder of the build no longer after a second
	log=$$(mktemp); trap "rm -f $$log" EXIT; (sleep 3; exec $(SINGLE) $(KEEP) --workspace $(DERIVED) --lib) >$$log 2>&1 & single=$$!; \
	$(WHOLE) $(KEEP) || { kill $$single; exit 1; }; \
	wait $$single && code=0 || code=$$?; cat $$log; $(EXAMPLES) $(KEEP) || code=$$?; exit $$code

laws:
	$(RUN) $(KEEP) --test laws $(if $(NEXTEST),--run-ignored only,-- --ignored)

unit:
	$(SINGLE) $(KEEP) --lib $(if $(CRATE),-p etalon-$(CRATE) --features etalon-$(CRATE)/schemas,--workspace $(DERIVED)) $(T)

quick:
	$(SINGLE) $(KEEP) --workspace $(DERIVED) --lib
	$(SINGLE) $(KEEP) $(DERIVED) --test etalon -- architecture golden
	$(EXAMPLES) $(KEEP)

# six parts of the time: two for attacks on files and processes, one each for drawn files, for mutants of statements and of data, and for readers
ATTACK ?= 600
DRAWS ?= 10000
SEED ?=
ATTACKS := cargo test --locked --release

attack:
	$(ATTACKS) --test etalon --test laws --no-run
	@seed=$(or $(SEED),$(shell date +%s)); part=$$(($(ATTACK) / 6)); echo "make attack SEED=$$seed ATTACK=$(ATTACK)"; \
	export ETALON_ATTACK_SEED=$$seed ETALON_MUTANTS_SEED=$$seed ETALON_FUZZ_SEED=$$seed; \
	export ETALON_ATTACK_SECONDS=$$((2 * part)) ETALON_MUTANTS_SECONDS=$$part ETALON_FUZZ_SECONDS=$$((part / 60)); \
	export ETALON_DRAWS=$(DRAWS) ETALON_DRAWS_SECONDS=$$part; \
	$(ATTACKS) --test etalon random_attacks -- --nocapture && \
	$(ATTACKS) --test etalon drawn_files -- --nocapture && \
	$(ATTACKS) --test etalon fuzz && \
	$(ATTACKS) --test laws mutants -- --include-ignored --nocapture --test-threads=1

bench:
	[ -x $(SHARED)/venv/bin/python ] || python3 -m venv $(SHARED)/venv
	$(SHARED)/venv/bin/pip install --quiet numpy scipy pandas || echo "NumPy, SciPy and pandas could not be installed: left out"
	$(SHARED)/venv/bin/pip install --quiet pin || echo "Pinocchio could not be installed: left out"
	PYTHON=$(SHARED)/venv/bin/python benches/page.sh

# peers that are not there are left out
bench-import:
	[ -x $(SHARED)/venv/bin/python ] || python3 -m venv $(SHARED)/venv
	$(SHARED)/venv/bin/pip install --quiet polars pandas || echo "polars and pandas could not be installed: left out"
	PYTHON=$(SHARED)/venv/bin/python cargo bench --locked --bench import

# peers that are not there are left out, and nothing is installed with root
bench-fit:
	[ -x $(SHARED)/venv/bin/python ] || python3 -m venv $(SHARED)/venv
	$(SHARED)/venv/bin/pip install --quiet numpy scipy || echo "NumPy and SciPy could not be installed: left out"
	if [ -f /usr/include/ceres/ceres.h ]; then \
	    c++ -O3 -I/usr/include/eigen3 benches/fit/ceres.cpp -o $(SHARED)/ceres_fit -lceres -lglog; \
	else echo "Ceres is not installed (libceres-dev of Debian): left out"; fi
	CARGO_TARGET_DIR=$(SHARED) CERES_FIT=$(SHARED)/ceres_fit PYTHON=$(SHARED)/venv/bin/python \
	    cargo run --release --locked --manifest-path benches/fit/Cargo.toml

thesis:
	cargo bench --locked --profile $(PROFILE) --bench thesis -- --out $(abspath $(CARGO_TARGET_DIR))/thesis

test-slurm: $(ETALON)
	tests/cluster/slurm.sh $(ETALON)

test-linuxcnc: $(ETALON)
	tests/linuxcnc/linuxcnc.sh $(ETALON)

REAL_SOURCE ?=

real: $(ETALON)
	REAL_SOURCE='$(subst ','\'',$(REAL_SOURCE))' tests/real/real.sh $(ETALON) $(CARGO_TARGET_DIR)/real

SETS ?=

# participants that are not there are named as failed
benchmark: $(ETALON)
	[ -x $(SHARED)/venv/bin/python ] || python3 -m venv $(SHARED)/venv
	$(SHARED)/venv/bin/pip install --quiet numpy scipy || echo "NumPy and SciPy could not be installed"
	$(SHARED)/venv/bin/pip install --quiet figaroh || echo "FIGAROH could not be installed: left out"
	$(SHARED)/venv/bin/python tests/benchmark/benchmark.py $(ETALON) $(abspath $(CARGO_TARGET_DIR))/benchmark \
	    $(if $(REAL_SOURCE),--source '$(subst ','\'',$(REAL_SOURCE))') $(if $(SETS),$(SETS:%=--set %),--page)

reference:
	tests/reference/campaigns/archive.sh $(CARGO_TARGET_DIR)/reference

samples: $(ETALON)
	for truth in samples/*/truth.toml; do $(ETALON) simulate -- "$${truth%/truth.toml}" || exit; done

# the wheel has its own libraries: it is built beside those of the program
PYTHON_BUILD := $(abspath $(CARGO_TARGET_DIR))/python
# `make python WHEEL="--profile dev --no-default-features"` builds one that is neither fast nor has report.pdf, in a fifth of the time
WHEEL ?= --release

python:
	[ -x $(PYTHON_BUILD)/venv/bin/python ] || python3 -m venv $(PYTHON_BUILD)/venv
	$(PYTHON_BUILD)/venv/bin/pip install --quiet 'maturin>=1.9,<2'
	rm -rf $(PYTHON_BUILD)/wheels
	CARGO_TARGET_DIR=$(PYTHON_BUILD)/target $(PYTHON_BUILD)/venv/bin/maturin build $(WHEEL) --locked --manifest-path python/Cargo.toml --out $(PYTHON_BUILD)/wheels
	$(PYTHON_BUILD)/venv/bin/pip install --quiet --force-reinstall --no-deps $(PYTHON_BUILD)/wheels/*.whl
	$(PYTHON_BUILD)/venv/bin/pip install --quiet numpy pytest
	$(PYTHON_BUILD)/venv/bin/pip install --quiet scipy polars pandas pyarrow jsonschema taplo distributed nbclient nbformat ipykernel matplotlib joblib mypy pyright rosbags openpyxl || echo "some peers could not be installed: tests with them are skipped"
	$(PYTHON_BUILD)/venv/bin/pytest -q -p no:cacheprovider python/tests
	ls $(PYTHON_BUILD)/wheels

# after `make python`
bench-python:
	PYTHON=$(PYTHON_BUILD)/venv/bin/python cargo bench --locked --bench python

figures: $(ETALON)
	python3 docs/figures/draw.py $(ETALON)

# what cargo installs beside the build
TOOLS := $(abspath $(CARGO_TARGET_DIR))/tools
MDBOOK := $(or $(shell command -v mdbook),$(TOOLS)/bin/mdbook)

book:
	[ -x $(MDBOOK) ] || cargo install --quiet --locked --root $(TOOLS) mdbook
	$(MDBOOK) build docs --dest-dir $(abspath $(CARGO_TARGET_DIR))/book
	.ci/links $(CARGO_TARGET_DIR)/book

# the program of a package names its own components (`.dep-v0`, cargo-auditable)
dist:
	for tool in cargo-cyclonedx cargo-auditable; do [ -x $(TOOLS)/bin/$$tool ] || cargo install --quiet --locked --root $(TOOLS) $$tool || exit; done
	PATH="$(TOOLS)/bin:$$PATH" cargo auditable build --profile $(PROFILE) --locked --bin etalon
	PATH="$(TOOLS)/bin:$$PATH" .ci/dist $(ETALON) $(CARGO_TARGET_DIR)/dist $(TARGETS)

clean:
	@for c in $(EACH); do [ ! -f "$$c/campaign.toml" ] || rm -rf -- "$$c/out" || exit; done

clean-%:
	@name='$(subst ','\'',$*)'; \
	for c in $(EACH); do if [ "$$(basename -- "$$c")" = "$$name" ]; then rm -rf -- "$$c/out" || exit; fi; done

help:
	@sed -n 's/^# make/make/p' Makefile
