# Veksel: a train running through a railway turnout.  make help
VERSION = 0.1.0

BUILD   = build
PREFIX ?= /usr/local
MANPREFIX ?= $(PREFIX)/share/man
CC ?= cc
-include config.mk

# make V=1 shows whole commands.
Q = $(if $(V),,@)

# Debian packages: what a build needs, what the tests need beside it.  OpenBLAS in its serial build: threads would only spin at start-up.
PACKAGES  = gcc libc6-dev make pkg-config libyaml-dev libxxhash-dev libsuitesparse-dev libarpack2-dev libopenblas-serial-dev \
            liblapacke-dev libfftw3-dev libhdf5-dev libosmesa6-dev libfreetype-dev libfontconfig-dev libpng-dev fonts-dejavu-core
TESTPACKAGES = perl mandoc

# SuiteSparse 5 has no pkg-config file; hdf5 alone may be the MPI build.  Recursive variables: the run of make that installs
# the packages can build with them.
PKG      = libpng freetype2 fontconfig
PKGCFLAGS = $(shell pkg-config --cflags $(PKG) hdf5-serial) -I/usr/include/suitesparse
PKGLIBS   = $(shell pkg-config --libs $(PKG) hdf5-serial)

WARN = -Wall -Wextra -Wpedantic -Wshadow -Wstrict-prototypes -Wmissing-prototypes -Wold-style-definition -Wvla \
       -Wwrite-strings -Wpointer-arith -Wundef -Wimplicit-fallthrough -Wformat=2 -Wfloat-conversion
CFLAGS ?= -O2 -g
STD    = -std=c17 -D_XOPEN_SOURCE=700 -fno-common -fno-math-errno -ffp-contract=off
# The comma would end an argument of $(if).
SANITIZE = -fsanitize=address,undefined
ALL_CFLAGS = $(STD) $(CFLAGS) $(WARN) $(if $(WERROR),-Werror) $(if $(SAN),$(SANITIZE) -fno-omit-frame-pointer) \
             $(if $(COV),--coverage) -I. -DVX_VERSION='"$(VERSION)"'
ALL_LDFLAGS = $(LDFLAGS) -Wl,--as-needed $(if $(SAN),$(SANITIZE)) $(if $(COV),--coverage)
LIBS = -lyaml -lcholmod -lklu -lamd -lcolamd -lbtf -lsuitesparseconfig -larpack -llapacke -lopenblas -lfftw3 -lOSMesa $(PKGLIBS) -lm

# A .c directly in tools/ is a program; every other .c of tools/ and formats/ goes into one archive.
PROGRAMS = $(patsubst tools/%.c,$(BUILD)/bin/%,$(wildcard tools/vx*.c))
ARCHIVED = $(patsubst %.c,$(BUILD)/%.o,$(wildcard formats/*.c tools/*/*.c))
TESTS    = $(patsubst tests/kernel/%.c,$(BUILD)/tests/%,$(wildcard tests/kernel/*.c)) \
           $(patsubst tests/fault/%.c,$(BUILD)/tests/fault/%,$(wildcard tests/fault/*.c))
SCRIPTS ?= $(sort $(wildcard tests/lint/*.t tests/cli/*.t tests/pipe/*.t tests/golden/*.t tests/fault/*.t))
DEPS     = $(BUILD)/.deps
FLAGS    = $(BUILD)/.flags

all: $(PROGRAMS)            ## build the programs into build/bin

# A failed command must not leave a half-made target that looks done.
.DELETE_ON_ERROR:
.SUFFIXES:
.PHONY: all deps demo check bench lint install uninstall dist clean help
.SECONDARY:

# The flags of the last build; written while the Makefile is read and only when they changed, so that nothing is rebuilt in vain.
# CFLAGS from packages are left out: they are not known before make deps.
FLAGLINE = $(CC) $(STD) $(CFLAGS) $(SAN) $(COV) $(WERROR) $(VERSION)
ifeq ($(filter clean help deps,$(MAKECMDGOALS)),)
$(shell mkdir -p $(BUILD); printf '%s\n' '$(subst ','\'',$(FLAGLINE))' | cmp -s - $(FLAGS) || printf '%s\n' '$(subst ','\'',$(FLAGLINE))' >$(FLAGS))
endif

$(BUILD)/%.o: %.c $(FLAGS) | $(DEPS)
	@mkdir -p $(@D)
	@echo "cc $<"
	$(Q)$(CC) $(ALL_CFLAGS) $(PKGCFLAGS) $(HOT) -MMD -MP -c -o $@ $<

$(BUILD)/libvx.a: $(ARCHIVED)
	$(Q)rm -f $@
	$(Q)ar rcsD $@ $^

$(BUILD)/bin/%: $(BUILD)/tools/%.o $(BUILD)/libvx.a
	@mkdir -p $(@D)
	@echo "ld $@"
	$(Q)$(CC) $(ALL_LDFLAGS) -o $@ $^ $(LIBS)

$(BUILD)/tests/%: $(BUILD)/tests/kernel/%.o $(BUILD)/libvx.a
	@mkdir -p $(@D)
	@echo "ld $@"
	$(Q)$(CC) $(ALL_LDFLAGS) -o $@ $^ $(LIBS)

# The allocator of these tests fails when told to.
comma = ,
WRAPPED = malloc calloc realloc free strdup strndup
$(BUILD)/tests/fault/%: $(BUILD)/tests/fault/%.o $(BUILD)/libvx.a
	@echo "ld $@"
	$(Q)$(CC) $(ALL_LDFLAGS) $(WRAPPED:%=-Wl$(comma)--wrap=%) -o $@ $^ $(LIBS)

-include $(patsubst %.o,%.d,$(ARCHIVED)) $(PROGRAMS:$(BUILD)/bin/%=$(BUILD)/tools/%.d) $(wildcard $(BUILD)/tests/*/*.d)

# The kernels of the time step, of the contact search and of the rounding of heads; what reads every number of a table.
$(BUILD)/formats/vxf.o $(BUILD)/formats/ctab.o: HOT = -O3
$(BUILD)/tools/integrate/%.o $(BUILD)/tools/creep/%.o $(BUILD)/tools/contact/%.o $(BUILD)/tools/vehicle/couplings.o $(BUILD)/tools/vehicle/law.o $(BUILD)/tools/profile/opening.o: HOT = -O3

deps: $(DEPS)               ## install the Debian packages that are missing

$(DEPS):
	@mkdir -p $(@D)
	@missing=$$(for p in $(PACKAGES) $(TESTPACKAGES); do \
	    dpkg-query -W -f '$${db:Status-Status}\n' $$p 2>/dev/null | grep -qx installed || echo $$p; done); \
	if [ -n "$$missing" ]; then \
	    if [ "$$(id -u)" = 0 ]; then sudo=; elif command -v sudo >/dev/null; then sudo=sudo; else \
	        echo "as root: apt-get install --no-install-recommends" $$missing >&2; exit 1; fi; \
	    $$sudo apt-get update -q && \
	    $$sudo env DEBIAN_FRONTEND=noninteractive apt-get install -q -y --no-install-recommends $$missing; fi
	@touch $@

# Tests make their own tables, of the kernels as they are.
check: export VX_CACHE =
check: $(PROGRAMS) $(TESTS) ## run the tests
	prove $(PROVEFLAGS) -e '' $(TESTS) $(SCRIPTS)

lint:                       ## the checks of form alone
	prove -e '' $(sort $(wildcard tests/lint/*.t))

install: all                ## install programs and pages under $(DESTDIR)$(PREFIX)
	install -d $(DESTDIR)$(PREFIX)/bin
	install $(PROGRAMS) $(DESTDIR)$(PREFIX)/bin
	for s in 1 5 7; do install -d $(DESTDIR)$(MANPREFIX)/man$$s && \
	    install -m 644 man/*.$$s $(DESTDIR)$(MANPREFIX)/man$$s || exit 1; done

uninstall:                  ## remove what install put there
	rm -f $(PROGRAMS:$(BUILD)/bin/%=$(DESTDIR)$(PREFIX)/bin/%)
	for p in man/*.[157]; do rm -f $(DESTDIR)$(MANPREFIX)/man$${p##*.}/$${p#man/}; done

dist:                       ## a source archive in build/
	git archive --prefix=veksel-$(VERSION)/ -o $(BUILD)/veksel-$(VERSION).tar.gz HEAD

clean:                      ## remove everything built
	rm -rf $(BUILD) out

help:                       ## this list
	@sed -n 's/^\([a-z]*\):.*## \(.*\)/\1	\2/p' $(filter Makefile %.mk,$(MAKEFILE_LIST)) | expand -t 12

include pipelines/demo.mk
include pipelines/yaw.mk
include pipelines/accuracy.mk
include pipelines/following.mk
include pipelines/moving.mk
include pipelines/track.mk
include pipelines/vehicles.mk
include tests/bench/bench.mk
