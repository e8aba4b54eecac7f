# SPDX-License-Identifier: Apache-2.0
# The thin front of the build: CMake presets do the work.
.PHONY: help setup build demo check install package docs format format-check bench sanitize clean

BUILD := build
JOBS := $(shell nproc)
DEMO_OUT := out/demo
PREFIX := /usr/local

help:
	@echo "make demo    install what is missing, build, run the paper's case, say where the report is"
	@echo "make check   the same set-up, then every test"
	@echo "make build   build/ionskin"
	@echo "make install put what is built below PREFIX (/usr/local); DESTDIR goes before it"
	@echo "make package a Debian package, in build/package"
	@echo "make docs    the pages, in docs/_build/html"
	@echo "make format  format the sources (clang-format 14)"
	@echo "make bench   time the stages on this machine"

setup:
	@scripts/install_packages.sh

build: setup
	@cmake --preset release
	@cmake --build --preset release --parallel $(JOBS)

demo: build
	$(BUILD)/ionskin run cases/paper.toml -o $(DEMO_OUT) --overwrite
	@echo "Report: $(CURDIR)/$(DEMO_OUT)/report.html"

# Builds nothing, so that root need not build.
install:
	@test -x $(BUILD)/ionskin || { echo "Nothing is built yet: make build" >&2; exit 1; }
	@DESTDIR="$(DESTDIR)" cmake --install $(BUILD) --prefix "$(PREFIX)" --strip
	@test -n "$(DESTDIR)" || test "$$(id -u)" -ne 0 || ldconfig

package: build
	@cd $(BUILD) && cpack
	@echo "Package: $$(ls -t $(CURDIR)/$(BUILD)/package/*.deb | head -1)"

# The cheap checks come first, so that a slip shows before the long build.
check: setup
	@scripts/check_format.sh
	@/usr/bin/python3 scripts/check_includes.py
	@/usr/bin/python3 scripts/check_equations.py
	@$(MAKE) --no-print-directory build sanitize
	@scripts/check_threads.sh $(JOBS)
	@scripts/fuzz.sh --smoke 8
	@cmake --build --preset release --target benchmarks --parallel $(JOBS)
	@ctest --preset release

# The unit tests and the Studio's server, compiled several sources at a time, under the address and undefined-behaviour
# sanitizers. The server has cases checked by the program that is built.
sanitize: build
	@cmake --preset sanitize
	@cmake --build --preset sanitize --target unit_tests --parallel $(JOBS)
	@ctest --preset sanitize

# Runs the verification set and the gallery's sweep once; remove build/docs/material to run them again.
docs: build
	@/usr/bin/python3 docs/generate/build.py --program $(BUILD)/ionskin --work $(BUILD)/docs --output docs/_build/html --material
	@echo "Pages: $(CURDIR)/docs/_build/html/index.html"

format:
	@git ls-files '*.cpp' '*.hpp' | xargs clang-format-14 -i

bench: build
	@cmake --build --preset release --target benchmarks --parallel $(JOBS)
	$(BUILD)/benchmarks/electrochemistry
	$(BUILD)/benchmarks/columns
	$(BUILD)/benchmarks/mechanics
	$(BUILD)/benchmarks/stages

clean:
	rm -rf build build-debug build-sanitize build-audit build-fuzz out docs/_build
