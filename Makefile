# make         run every sample campaign (each writes samples/NAME/out/report.html)
# make test    run the tests
# make bench   compare with a peer, side by side in the same run (needs Python with numpy and scipy)
# make bench-fit compare the fits of elements with engeom, Ceres and SciPy (builds engeom: ten minutes and more the first time)
# make bench-import read ten million points beside polars and pandas (installs them beside the build)
# make samples make the synthetic samples again from their truth
# make help    this text
SHELL := /bin/bash
.SHELLFLAGS := -euo pipefail -c
MAKEFLAGS += --no-builtin-rules --warn-undefined-variables
.SUFFIXES:
.DELETE_ON_ERROR:
.DEFAULT_GOAL := all

CARGO_TARGET_DIR ?= target
# make PROFILE=dev takes the program that the tests have built already
PROFILE ?= release
ETALON := $(CARGO_TARGET_DIR)/$(PROFILE:dev=debug)/etalon
SOURCES := Cargo.toml Cargo.lock $(shell find src -type f)
CAMPAIGNS := $(patsubst samples/%/campaign.toml,%,$(sort $(wildcard samples/*/campaign.toml)))
SYNTHETIC := $(patsubst samples/%/truth.toml,%,$(sort $(wildcard samples/*/truth.toml)))

SHARED := $(abspath $(CARGO_TARGET_DIR))/bench-fit

.PHONY: all test bench bench-fit bench-import samples help clean
all: $(CAMPAIGNS:%=samples/%/out/report.html)

$(ETALON): $(SOURCES)
	cargo build --profile $(PROFILE) --locked

# a campaign is run again when one of its files or the program has changed
.SECONDEXPANSION:
samples/%/out/report.html: $$(shell find samples/$$* -type f -not -path '*/out/*') $(ETALON)
	$(ETALON) run --skip-missing samples/$*

# what is slow in tests runs in the profile of the program itself
test:
	[ -n "$${ETALON_REFERENCE:-}" ] || echo "ETALON_REFERENCE is not set: the tests in tests/reference (NIST, PreXYT, IRB 120) are skipped"
	cargo test --locked --doc
	if command -v cargo-nextest >/dev/null; then \
	    cargo nextest run --locked --lib --bins --test etalon && cargo nextest run --locked --release --test laws; \
	else cargo test --locked --lib --bins --test etalon && cargo test --locked --release --test laws; fi

bench:
	cargo bench --locked --bench identify --bench plan

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

samples: $(ETALON)
	for name in $(SYNTHETIC); do $(ETALON) simulate samples/$$name; done

clean:
	rm -rf $(CAMPAIGNS:%=samples/%/out)

help:
	@sed -n 's/^# make/make/p' Makefile
