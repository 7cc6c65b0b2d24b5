# Modeling in Context: one command each.
#
#   make run      FreeCAD with the bookshelf example; without a display, its files in build/bookshelf
#   make test     lint, types, tests in Python and inside this system's FreeCAD
#   make test-matrix  the tests inside FreeCAD 0.20, 1.0 and 1.1; the newer two are fetched once
#   make test-others  FreeCAD 1.0 and 1.1, and the solver with the oldest numpy and scipy: what `make test` leaves out
#   make setup    what the two need: packages of Debian, and .venv
#   make bench    the solver beside the paper's, Lipson's and SolveSpace's: one table
#   make gallery  the pictures and facts of every example, in resources/docs/gallery.md
#   make scenes   the examples' photos anew, into build/scenes; needs Blender
#   make lint     make types     make format     make clean
#
# Made for Debian 12 with nothing but git and make on it. Stamp files remember what is there
# already, so that a second run starts at once and asks no network.

PYTHON3 ?= /usr/bin/python3
VENV := .venv
PYTHON := $(VENV)/bin/python
READY := $(VENV)/.ready

RUN_PACKAGES := freecad python3-venv
TEST_PACKAGES := xvfb xauth openbox xdotool imagemagick \
	inkscape python3-lxml python3-numpy python3-cssselect python3-tinycss2 librecad prusa-slicer admesh \
	poppler-utils librsvg2-bin gmsh
MATRIX_PACKAGES := debootstrap python3-numpy python3-scipy
SUDO := $(if $(filter-out 0,$(shell id -u)),sudo)

# Which of some packages of Debian are not installed.
missing = $(strip $(foreach p,$(1),$(if $(filter installed,$(shell \
	dpkg-query -W -f '$${db:Status-Status}' $(p) 2>/dev/null)),,$(p))))

# Installs what is missing of some packages; does nothing, and asks for no password, if nothing is.
define apt_install
	$(if $(call missing,$(1)),$(SUDO) apt-get update)
	$(if $(call missing,$(1)),$(SUDO) env DEBIAN_FRONTEND=noninteractive apt-get install \
		--yes --no-install-recommends $(call missing,$(1)))
endef

.PHONY: run test test-matrix test-others setup bench gallery scenes lint types format clean

run: $(READY)
	@$(PYTHON) -m incontext.workbench.launch

test: $(READY) build/.test-packages
	@$(PYTHON) tests/stages.py

test-matrix: $(READY) build/.test-packages build/.matrix-packages
	@$(PYTHON) tests/stages.py console window freecad_1_0 freecad_1_1

test-others: $(READY) build/.test-packages build/.matrix-packages
	@$(PYTHON) tests/stages.py oldest freecad_1_0 freecad_1_1

setup: $(READY) build/.test-packages

gallery: $(READY)
	@$(PYTHON) -m incontext.workbench.gallery

# SCENES=chair_box makes one; BLENDER may be a Python that has the package bpy, with its denoiser.
BLENDER ?= blender -b -noaudio --python
SCENES ?= bookshelf organizer desk_tidy teapot_lid cup_saucer scissors_cover chair_box
scenes:
	@mkdir -p build/scenes
	@for name in $(SCENES); do $(BLENDER) resources/scenes/$$name.py -- build/scenes/$$name.jpg \
		--truth build/scenes/$$name.json || exit 1; done

bench: $(READY)
	@$(PYTHON) -m incontext.workbench bench

lint: $(READY)
	@$(PYTHON) tests/stages.py lint

types: $(READY)
	@$(PYTHON) tests/stages.py types

format: $(READY)
	@$(PYTHON) -m ruff format .
	@$(PYTHON) -m ruff check --fix .

clean:
	rm -rf build dist *.egg-info .pytest_cache .ruff_cache .mypy_cache .hypothesis
	find . -name __pycache__ -not -path './$(VENV)/*' -prune -exec rm -rf {} +

build/.run-packages:
	$(call apt_install,$(RUN_PACKAGES))
	@mkdir -p $(@D) && touch $@

build/.test-packages: build/.run-packages
	$(call apt_install,$(TEST_PACKAGES))
	@mkdir -p $(@D) && touch $@

build/.matrix-packages: build/.test-packages
	$(call apt_install,$(MATRIX_PACKAGES))
	@mkdir -p $(@D) && touch $@

# The packages of Debian come first, but are no reason to make the environment again.
$(READY): pyproject.toml resources/requirements.lock | build/.run-packages
	@echo 'Setting up $(VENV): about 2 GB of Python packages, which takes some minutes once.'
	$(PYTHON3) -m venv $(VENV)
	$(PYTHON) -m pip install --quiet --disable-pip-version-check --no-input \
		--constraint resources/requirements.lock --editable '.[test]'
	@touch $@
