# SPDX-License-Identifier: Apache-2.0
# The thin front of the build: CMake presets do the work.
.PHONY: help setup setup-demo setup-check setup-all build demo check-sources quick check check-long separate install package wheel docs format bench clean

BUILD := build
JOBS := $(shell nproc)
DEMO_OUT := out-demo
PREFIX := /usr/local

help:
	@echo "make demo    install what a run needs, build that, run the paper's case, say where the report is"
	@echo "make quick   sources, unit tests and one run: minutes once ionskin is built, while one works"
	@echo "make check   a part of every kind of test: a quarter of an hour, before every push"
	@echo "make check-long   every test: hours, before a release"
	@echo "make build   install what every part needs, build all: build/ionskin"
	@echo "make install put what is built below PREFIX (/usr/local); DESTDIR goes before it"
	@echo "make package a Debian package, in build/package"
	@echo "make wheel   a wheel for pip, in build/wheel"
	@echo "make docs    the pages, in docs/_build/html"
	@echo "make format  format the sources (clang-format 14)"
	@echo "make bench   time the stages on this machine"

# Tiers of packages.txt.
setup-demo:
	@scripts/install_packages.sh program

setup:
	@scripts/install_packages.sh program parts

setup-check:
	@scripts/install_packages.sh program parts tests uncertainty cluster arrays pages notebooks mujoco

setup-all:
	@scripts/install_packages.sh

build: setup
	@cmake --preset release
	@cmake --build --preset release --parallel $(JOBS)

demo: setup-demo
	@cmake --preset release
	@cmake --build --preset release --target ionskin --parallel $(JOBS)
	$(BUILD)/ionskin run cases/paper.toml -o $(DEMO_OUT) --overwrite
	@echo "Report: $(CURDIR)/$(DEMO_OUT)/report.html"

# Builds nothing, so that root need not build.
install:
	@test -e $(BUILD)/libionskin.so || { echo "Not every part is built yet: make build" >&2; exit 1; }
	@DESTDIR="$(DESTDIR)" cmake --install $(BUILD) --prefix "$(PREFIX)" --strip
	@test -n "$(DESTDIR)" || test "$$(id -u)" -ne 0 || ldconfig

package: build
	@cd $(BUILD) && cpack
	@echo "Package: $$(ls -t $(CURDIR)/$(BUILD)/package/*.deb | head -1)"

wheel: build
	@cmake --build --preset release --target wheel

# The cheap checks come first, so that a slip shows before the long build.
check-sources: setup-check
	@scripts/check_format.sh
	@/usr/bin/python3 scripts/check_includes.py
	@/usr/bin/python3 scripts/check_equations.py
	@/usr/bin/python3 scripts/check_comments.py
	@/usr/bin/python3 scripts/check_packages.py

quick: check-sources build
	@cmake --build --preset release --target unit_tests --parallel $(JOBS)
	@/usr/bin/python3 scripts/run_tests.py quick

# What reads users' files also runs under the address and undefined-behaviour sanitizers, what hands memory between threads
# under that for threads. CONTRIBUTING.md says what each tier holds.
check: check-sources build
	@cmake --build --preset release --target unit_tests --parallel $(JOBS)
	@cmake --preset sanitize
	@cmake --build --preset sanitize --parallel $(JOBS)
	@/usr/bin/python3 scripts/run_tests.py sanitize
	@scripts/fuzz.sh 3 "$$(mktemp -d)" 1
	@scripts/check_threads.sh threads $(JOBS)
	@/usr/bin/python3 scripts/run_tests.py check

# A step that fails does not keep the next from being seen. The steps hold those of `check`.
check-long: setup-all check-sources build
	@cmake --build --preset release --target unit_tests benchmarks --parallel $(JOBS)
	@failed=; \
	for step in "/usr/bin/python3 scripts/run_tests.py check" "/usr/bin/python3 scripts/run_tests.py long" \
	    "cmake --preset sanitize" "cmake --build --preset sanitize-long --parallel $(JOBS)" \
	    "/usr/bin/python3 scripts/run_tests.py sanitize-long" "scripts/fuzz.sh 60" "scripts/check_threads.sh threads-long $(JOBS)"; do \
	  echo "== $$step"; $$step || failed="$$failed; $$step"; \
	done; \
	test -z "$$failed" || { echo "failed: $${failed#; }" >&2; exit 1; }

# Every source by itself: the release and the sanitizers compile several together, where a missing include does not show.
separate: setup-check
	@cmake --preset separate
	@cmake --build --preset separate --parallel $(JOBS)

# Runs the verification set and the gallery's sweep once; remove build/docs/material to run them again.
docs: setup-check build
	@/usr/bin/python3 docs/generate/build.py --program $(BUILD)/ionskin --work $(BUILD)/docs --output docs/_build/html --material
	@echo "Pages: $(CURDIR)/docs/_build/html/index.html"

format:
	@git ls-files '*.cpp' '*.hpp' | xargs clang-format-14 -i

bench: setup-check build
	@cmake --build --preset release --target benchmarks --parallel $(JOBS)
	$(BUILD)/benchmarks/electrochemistry
	$(BUILD)/benchmarks/columns
	$(BUILD)/benchmarks/mechanics
	$(BUILD)/benchmarks/stages

clean:
	rm -rf build build-debug build-separate build-sanitize build-audit build-threads out docs/_build
