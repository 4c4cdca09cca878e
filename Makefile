# make         run the campaigns in samples/ and campaigns/ that have changed, and list how each ended; with -j several at once
# make CAMPAIGNS="FOLDER ..." the same of other folders, whose names hold no spaces
# make report  write their reports again from the documents in out/
# make compare CAMPAIGNS="FOLDER ..." compare campaigns of one robot, the oldest first
# make clean-NAME remove the output of campaign NAME; make clean that of all
# make test    run the tests
# make quick   the tests of single files, of the architecture and of golden documents: before each commit
# make unit CRATE=NAME those of one crate, some seconds after an edit; T=NAME only those whose path holds NAME
# make bench   compare with SciPy, NumPy and Pinocchio, side by side in the same run, and write benches/README.md; COUNT= sets how many campaigns
# make bench-fit compare the fits of elements with engeom, Ceres and SciPy (builds engeom: ten minutes and more the first time)
# make bench-import read ten million points beside polars and pandas (installs them beside the build)
# make thesis  the tables and figures of the thesis, printed and computed side by side: target/thesis/thesis.html and thesis.md
# make test-slurm run campaigns on a Slurm cluster of two nodes on this machine, and kill one (needs root, slurm-wlm and munge)
# make test-linuxcnc load exported kinematics into LinuxCNC and compare its joint positions (needs root; installs linuxcnc-uspace of Debian)
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
T ?=
CRATE ?=
CAMPAIGNS ?= $(patsubst %/campaign.toml,%,$(sort $(wildcard samples/*/campaign.toml campaigns/*/campaign.toml)))
SYNTHETIC := $(patsubst samples/%/truth.toml,%,$(sort $(wildcard samples/*/truth.toml)))

SHARED := $(abspath $(CARGO_TARGET_DIR))/bench-fit

.PHONY: all report compare test quick unit test-slurm test-linuxcnc thesis bench bench-fit bench-import samples help clean FORCE

# how the run of a campaign ended: NAME.status, or NAME.failed where it is to be tried again
ENDED := $(abspath $(CARGO_TARGET_DIR))/campaigns
ended = $(ENDED)/$(subst /,_,$(abspath $(1)))
# several campaigns at once: each on one thread
ALONE = $(if $(findstring jobserver,$(MAKEFLAGS)),RAYON_NUM_THREADS=1 POLARS_MAX_THREADS=1)

# a campaign that fails stops no other
all: $(foreach c,$(CAMPAIGNS),$(call ended,$(c)).status)
	@bad=0; for both in $(foreach c,$(CAMPAIGNS),$(c):$(call ended,$(c))); do \
	    c=$${both%%:*}; at=$${both#*:}; how=failed; \
	    if [ -f $$at.skipped ]; then how=skipped; \
	    elif [ -f $$at.status ]; then if [ "$$(<$$at.status)" = 0 ]; then how=done; else how='limits not met'; fi; fi; \
	    case $$how in failed|limits*) bad=1;; esac; \
	    printf '%-40s %s\n' "$$c" "$$how"; \
	done; exit $$bad

$(ETALON): $(SOURCES)
	cargo build --profile $(PROFILE) --locked

# a campaign is run again when one of its files or the program has changed, or its report is not there
.SECONDEXPANSION:
define campaign
$(call ended,$(1)).status: $$$$(shell find $(1)/ -mindepth 1 \( -name '.*' -o -name out \) -prune -o -type f -print) $(ETALON) \
    $$$$(if $$$$(wildcard $(1)/out/report.html),,FORCE)
	@mkdir -p $(ENDED); at=$(call ended,$(1)); rm -f $$$$at.status $$$$at.failed $$$$at.skipped; \
	$$(ALONE) $(ETALON) run --skip-missing $(1) >$$$$at.log 2>&1 && code=0 || code=$$$$?; echo "$(ETALON) run $(1)"; cat $$$$at.log; \
	if grep -q '^skipped: ' $$$$at.log; then : >$$$$at.skipped; fi; \
	if [ $$$$code -le 1 ]; then echo $$$$code >$$$$at.status; else : >$$$$at.failed; fi
endef
$(foreach c,$(CAMPAIGNS),$(eval $(call campaign,$(c))))
FORCE:

report: $(ETALON)
	@for c in $(CAMPAIGNS); do [ ! -f $$c/out/manifest.json ] || $(ETALON) report $$c/out || exit; done

compare: $(ETALON)
	$(ETALON) compare $(CAMPAIGNS)

# the libraries are built once, as the program has them; etalon's own crates are not optimised for the tests of single files
CRATES := $(patsubst src/%/Cargo.toml,etalon-%,$(wildcard src/*/Cargo.toml)) etalon
UNOPTIMISED := $(foreach crate,$(CRATES),$(foreach option,opt-level=0 debug-assertions=true codegen-units=256,--config profile.release.package.$(crate).$(option)))
RUN := cargo $(if $(shell command -v cargo-nextest),nextest run --no-fail-fast,test --no-fail-fast) --locked --release
WHOLE := $(RUN) --test laws --test etalon
SINGLE := env CARGO_INCREMENTAL=1 $(RUN) $(UNOPTIMISED)

test:
	[ -n "$${ETALON_REFERENCE:-}" ] || echo "ETALON_REFERENCE is not set: tests on outside data (NIST, PreXYT, IRB 120) are skipped"
	$(WHOLE) --no-run
	@# those of single files are compiled while the others run, which hold the folder of the build no longer after a second
	log=$$(mktemp); trap "rm -f $$log" EXIT; (sleep 3; exec $(SINGLE) --workspace --lib) >$$log 2>&1 & single=$$!; \
	$(WHOLE) || { kill $$single; exit 1; }; \
	wait $$single && code=0 || code=$$?; cat $$log; exit $$code

unit:
	$(SINGLE) --lib $(if $(CRATE),-p etalon-$(CRATE),--workspace) $(T)

quick:
	$(SINGLE) --workspace --lib --test etalon -E 'kind(lib) | test(/^(architecture|golden)/)'

bench:
	[ -x $(SHARED)/venv/bin/python ] || python3 -m venv $(SHARED)/venv
	$(SHARED)/venv/bin/pip install --quiet numpy scipy || echo "NumPy and SciPy could not be installed: left out"
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

samples: $(ETALON)
	for name in $(SYNTHETIC); do $(ETALON) simulate samples/$$name || exit; done

clean: $(foreach c,$(CAMPAIGNS),clean-$(notdir $(c)))

clean-%:
	rm -rf $(foreach c,$(filter %/$* $*,$(CAMPAIGNS)),$(c)/out $(call ended,$(c)).*)

help:
	@sed -n 's/^# make/make/p' Makefile
