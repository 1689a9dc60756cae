# SPDX-License-Identifier: GPL-3.0-or-later
#
# phspline: the whole build, in one non-recursive GNU make file (3.81 or newer).
# `make' builds build/plain/phspline, `make help' says what else there is.
#
# Three layers, each overriding the one before: the defaults below, config.mk
# (written by ./configure, never needed), and the command line.  Sources are
# found, not listed: a new file below src/ or tests/ needs no edit here.
#
# Objects live in build/$(VARIANT)/ so that the plain, asan, tsan, cov and fuzz
# builds coexist; any other name, as in `make CC=clang VARIANT=clang',
# is a plain build elsewhere.  To build out of tree run configure, or `make -f
# /there/Makefile', in the directory that gets build/ (paths without blanks).

# ---- where things are --------------------------------------------------------

srcdir := $(patsubst %/,%,$(dir $(lastword $(MAKEFILE_LIST))))
# the prefix of every source path: nothing when the source is here
S := $(if $(filter .,$(srcdir)),,$(srcdir)/)
VARIANT = plain
B = build/$(VARIANT)
VERSION := $(shell sed -n 's/.*PH_VERSION "\(.*\)".*/\1/p' \
	$(S)src/base/version.h)
DIST = phspline-$(VERSION)

# ---- defaults; environment, config.mk and command line override them ---------

prefix ?= /usr/local
exec_prefix ?= $(prefix)
bindir ?= $(exec_prefix)/bin
datarootdir ?= $(prefix)/share
datadir ?= $(datarootdir)
mandir ?= $(datarootdir)/man
docdir ?= $(datarootdir)/doc/phspline
INSTALL ?= install
INSTALL_PROGRAM ?= $(INSTALL)
INSTALL_DATA ?= $(INSTALL) -m 644

CFLAGS ?= -O2 -g
PKG_CONFIG ?= pkg-config
GCOV ?= gcov
VALGRIND ?= valgrind -q --error-exitcode=9 --leak-check=full \
	--errors-for-leak-kinds=definite,possible \
	--suppressions=$(abspath $(srcdir)/tests/suppress/valgrind)
# seconds for each fuzz target, and its seed (0: any); how unit tests are
# compiled; 1: asan does less; test files run at once; what `make deps' gets;
# what distcheck runs in the unpacked tree
FUZZ_TIME ?= 60
FUZZ_SEED ?= 0
UNIT_CFLAGS ?= -O0 -g1 -U_FORTIFY_SOURCE
SHORT ?= 1
TEST_JOBS ?= $(shell getconf _NPROCESSORS_ONLN 2>/dev/null || echo 1)
DEPS ?= build test $(PLOT) $(VOLUME) $(XML)
DISTCHECK_TARGETS ?= check

# $(call pkg,OPTION,MODULE,FALLBACK): ask pkg-config, or hope for the best
pkg = $(shell $(PKG_CONFIG) $1 $2 2>/dev/null || echo $3)
ifndef GSL_LIBS
GSL_CFLAGS := $(call pkg,--cflags,gsl)
GSL_LIBS := $(call pkg,--libs,gsl,-lgsl -lgslcblas)
endif
ifndef CJSON_LIBS
CJSON_CFLAGS := $(call pkg,--cflags,libcjson)
CJSON_LIBS := $(call pkg,--libs,libcjson,-lcjson)
endif
ifndef CHECK_LIBS
CHECK_CFLAGS := $(call pkg,--cflags,check)
CHECK_LIBS := $(call pkg,--libs,check,-lcheck)
endif
# nothing where there is no cairo
ifndef CAIRO_LIBS
CAIRO_CFLAGS := $(call pkg,--cflags,cairo)
CAIRO_LIBS := $(call pkg,--libs,cairo)
endif

# nothing where there is no teem, of which pkg-config knows nothing
ifndef TEEM_LIBS
TEEM_LIBS := $(shell printf '%s\n' '#include <teem/nrrd.h>' 'int main(void)' \
	'{ return !nrrdLoad; }' | $(CC) -x c -o /dev/null - -lteem 2>/dev/null && \
	echo -lteem)
endif

# nothing where there is no expat
ifndef EXPAT_LIBS
EXPAT_CFLAGS := $(call pkg,--cflags,expat)
EXPAT_LIBS := $(call pkg,--libs,expat)
endif

-include config.mk

# No cairo, no --plot; the rest works.  WITHOUT_CAIRO=1, as ./configure
# --without-cairo, leaves out one that is there.
CAIRO = $(if $(WITHOUT_CAIRO),,$(CAIRO_LIBS))
PLOT = $(if $(WITHOUT_CAIRO),,plot)
# No teem, no --panorama: the same with WITHOUT_TEEM=1.
TEEM = $(if $(WITHOUT_TEEM),,$(TEEM_LIBS))
# Few runs need these two, and to load them takes longer than all the rest: each
# is loaded when it is needed, by the name that a program has for it that is
# linked with it; without a name, as of one that is not shared, it is linked.
ifneq ($(CAIRO)$(TEEM),)
NEEDED := $(shell probe=$$(mktemp) && { printf '%s\n' '#include <dlfcn.h>' \
	$(if $(CAIRO),'#include <cairo.h>') \
	$(if $(TEEM),'#include <teem/nrrd.h>') 'int main(void) { return !dlerror()' \
	$(if $(CAIRO),'|| !cairo_version()') $(if $(TEEM),'|| !nrrdNew()') '; }' | \
	$(CC) $(CAIRO_CFLAGS) $(TEEM_CFLAGS) $(CPPFLAGS) -x c -o "$$probe" - \
	$(LDFLAGS) $(CAIRO) $(TEEM) -ldl && readelf -d "$$probe" | \
	sed -n 's/.*NEEDED.*\[\(.*\)\]/\1/p'; rm -f "$$probe"; } 2>/dev/null)
endif
CAIRO_NAME := $(filter libcairo%,$(NEEDED))
TEEM_NAME := $(filter libteem%,$(NEEDED))
VOLUME = $(if $(WITHOUT_TEEM),,volume)
# No expat, no SVG nor GPX as input: the same with WITHOUT_EXPAT=1.
EXPAT = $(if $(WITHOUT_EXPAT),,$(EXPAT_LIBS))
XML = $(if $(WITHOUT_EXPAT),,xml)

# ---- flags -------------------------------------------------------------------
# Order: warnings (CFLAGS may silence one), CFLAGS, then what the results depend
# on and nobody overrides.  No contraction into FMA: it changes last digits from
# one processor to the next.  For a processor that has FMA nothing is vectorised:
# gcc 12 fuses the products of complex numbers that it vectorises, whatever
# -ffp-contract says.  -ffast-math would break NaN tests: never add it.

WARNINGS = -Wall -Wextra -Wshadow -Wstrict-prototypes -Wmissing-prototypes \
	-Wvla -Wdouble-promotion -Wfloat-equal $(if $(WERROR),-Werror)
FMA := $(findstring __FP_FAST_FMA,$(shell $(CC) $(CPPFLAGS) $(CFLAGS) -dM \
	-E -x c /dev/null 2>/dev/null))
MANDATORY = -std=c11 -ffp-contract=off $(if $(FMA),-fno-tree-vectorize \
	-fno-tree-slp-vectorize) -pthread -D_POSIX_C_SOURCE=200809L -I$(S)src

VFLAGS_asan = -O1 -g1 -fno-omit-frame-pointer -fsanitize=address,undefined \
	-fno-sanitize-recover=all -DPH_FAULT_INJECTION
VFLAGS_tsan = -O1 -g1 -fno-omit-frame-pointer -fsanitize=thread
VFLAGS_cov = -O0 --coverage
VFLAGS_fuzz = -O1 -g1 -fno-omit-frame-pointer -fno-sanitize-recover=all \
	-fsanitize=fuzzer-no-link,address,undefined

# Hardening, as far as the compiler has it and CFLAGS and LDFLAGS, which come
# after it, allow; none beside sanitizers, whose programs are started by the
# thousand: without shared libraries and without relocations, of which every
# global of theirs has several, a start takes half as long.  Found out once (see
# below).
HARDENING = $(if $(findstring -fsanitize,$(ALL_FLAGS)),$(if $(filter \
	asan,$(VARIANT)),-static-libasan -static-libubsan '-fno-pie -no-pie'), \
	-D_FORTIFY_SOURCE=2 -fstack-protector-strong -Wl,-z,relro,-z,now \
	$(if $(filter -static% -no-pie -nopie -fno-pi% -fno-PI%,$(ALL_FLAGS)),, \
	'-fPIE -pie'))
PLAIN = $(if $(findstring -fsanitize,$(ALL_FLAGS)),-fno-sanitize=all)
ALL_FLAGS = $(CC) $(CPPFLAGS) $(CFLAGS) $(VFLAGS_$(VARIANT)) $(LDFLAGS)
hardening = $(shell sed 1d $(B)/hardening 2>/dev/null)

COMPILE = $(CC) $(WARNINGS) $(filter -D% -f%,$(hardening)) $(GSL_CFLAGS) \
	$(CJSON_CFLAGS) $(if $(CAIRO),-DPH_CAIRO $(CAIRO_CFLAGS)) \
	$(if $(CAIRO_NAME),-DPH_CAIRO_NAME='"$(CAIRO_NAME)"') \
	$(if $(TEEM),-DPH_TEEM $(TEEM_CFLAGS)) \
	$(if $(TEEM_NAME),-DPH_TEEM_NAME='"$(TEEM_NAME)"') \
	$(if $(EXPAT),-DPH_EXPAT $(EXPAT_CFLAGS)) $(CPPFLAGS) $(CFLAGS) \
	$(MANDATORY) $(VFLAGS_$(VARIANT))
LINK = $(CC) $(filter-out -D%,$(hardening)) $(CFLAGS) $(MANDATORY) \
	$(VFLAGS_$(VARIANT)) $(LDFLAGS)
LIBRARIES = $(GSL_LIBS) $(CJSON_LIBS) $(if $(CAIRO_NAME),,$(CAIRO)) \
	$(if $(TEEM_NAME),,$(TEEM)) $(if $(CAIRO_NAME)$(TEEM_NAME),-ldl) $(EXPAT) \
	$(LIBS) -lm

# V=1 shows whole command lines
Q = $(if $(V),,@)
SAY = @$(if $(V),:,echo)
AGAIN = $(MAKE) --no-print-directory -f $(firstword $(MAKEFILE_LIST))
SUBMAKE = +@$(AGAIN)

# ---- what there is -----------------------------------------------------------

# $(call files,DIRECTORIES,NAME): sorted, relative to the source directory
files = $(sort $(shell cd $(srcdir) && find $1 -name '$2' 2>/dev/null))

SRC := $(call files,src,*.c)
UNIT_SRC := $(call files,tests/unit tests/prop,*.c)
# helper programs of the shell tests, which find them on PATH
TOOL_SRC := $(call files,tests/cli,*.c)
# what IPOPT does is measured where it is installed
IPOPT_LIBS := $(call pkg,--libs,ipopt)
BENCH_SRC := $(filter-out $(if $(IPOPT_LIBS),,bench/arclength_ipopt.c),\
	$(call files,bench,*.c))
# ... and what GEOS and Clipper do, which is C++
PEERS_LIBS := $(if $(call pkg,--libs,geos),$(call pkg,--libs,polyclipping))
PEERS_LIBS := $(if $(PEERS_LIBS),$(PEERS_LIBS) $(call pkg,--libs,geos))
FUZZ_SRC := $(call files,tests/fuzz,*.c)
CLI_TESTS := $(call files,tests/cli,*.t)
LONG_TESTS := $(addprefix tests/cli/,bubble-orders.t cone-pairs.t trim-many.t)
FAULT_TESTS := $(call files,tests/fault,*.t)
LINTS := $(call files,tests/lint,*.sh)
# ... of which `make check' runs
QUICK_LINTS = tests/lint/layers.sh tests/lint/headers.sh
MAN := $(call files,man,*.[1-9])

obj = $(patsubst %.c,$(B)/%.o,$1)
exe = $(patsubst %.c,$(B)/%,$1)
MAIN_OBJ = $(call obj,src/cli/main.c)
LIB_OBJ = $(filter-out $(MAIN_OBJ),$(call obj,$(SRC)))
LIB = $(B)/libph.a
PROGRAM = $(B)/phspline
# tests/unit/t_*.c are programs; they take what they need of the other files
UNIT_MAIN = $(foreach f,$(UNIT_SRC),$(if $(filter t_%,$(notdir $f)),$f))
UNIT_AUX = $(call obj,$(filter-out $(UNIT_MAIN),$(UNIT_SRC)))
UNIT_LIB = $(B)/libunit.a
UNIT = $(call exe,$(UNIT_MAIN))
TOOLS = $(call exe,$(TOOL_SRC))
BENCH = $(call exe,$(BENCH_SRC))
FUZZ = $(call exe,$(FUZZ_SRC))
OBJ = $(call obj,$(SRC) $(UNIT_SRC) $(TOOL_SRC) $(BENCH_SRC) $(FUZZ_SRC))

# ---- build -------------------------------------------------------------------

.DEFAULT_GOAL := all
# `make -j clean check': goals one after the other, each of them in parallel
$(if $(word 2,$(MAKECMDGOALS)),$(eval .NOTPARALLEL:))
.DELETE_ON_ERROR:
.SUFFIXES:
.PHONY: FORCE all install uninstall deps tests-build tests-syntax check \
	check-run demo demo-run asan asan-run tsan tsan-run valgrind valgrind-run coverage \
	coverage-run lint lint-run fuzz fuzz-run bench bench-run check-long \
	check-long-run check-cluster check-cluster-run static static-run \
	check-rates check-rates-run figures figures-run configure \
	dist distcheck deb check-deb clean distclean help

all: $(PROGRAM) ## build build/plain/phspline (the default)

$(PROGRAM): $(MAIN_OBJ)
$(LIB): $(LIB_OBJ)
$(UNIT_LIB): $(UNIT_AUX)
$(LIB) $(UNIT_LIB): $(B)/objects
	$(SAY) "  AR  $@"
	$(Q)rm -f $@ && $(AR) qcs $@ $(filter %.o,$^)

$(OBJ): $(B)/%.o: $(S)%.c $(B)/flags $(B)/libraries
	$(SAY) "  CC  $<"
	@mkdir -p $(@D)
	$(Q)$(COMPILE) $(EXTRA_CFLAGS) -MMD -MP -c -o $@ $<

# Their references are in long double, to which doubles are promoted on purpose.
# They run for a moment, and are the larger part of what is compiled: without
# optimisation that takes half the time.  In them no undefined behaviour is
# looked for, but addresses are: what they hand over has its guards.
$(call obj,$(UNIT_SRC)): EXTRA_CFLAGS = -I$(S)tests/unit -Wno-double-promotion \
	$(UNIT_CFLAGS) $(if $(filter asan,$(VARIANT)),-fno-sanitize=undefined) \
	$(CHECK_CFLAGS)
# What they compare tells a fuzzer nothing, and to trace it takes four fifths of
# the time: comparisons are traced where bytes are read.
NUMERIC = $(filter src/kernel/% src/curve/% src/solve/% src/check/%,$(SRC))
$(call obj,$(NUMERIC)): EXTRA_CFLAGS = $(if $(filter fuzz,$(VARIANT)),\
	-fno-sanitize-coverage=trace-cmp)
$(UNIT): EXTRA_LIBS = $(CHECK_LIBS)
$(UNIT): $(UNIT_LIB)
$(FUZZ): EXTRA_LIBS = -fsanitize=fuzzer
$(B)/bench/arclength_ipopt.o: EXTRA_CFLAGS = $(call pkg,--cflags,ipopt)
$(B)/bench/arclength_ipopt: EXTRA_LIBS = $(IPOPT_LIBS)
$(B)/bench/trim_peers: $(S)bench/trim_peers.cc $(S)bench/bench.h
	$(SAY) "  CXX $<"
	@mkdir -p $(@D)
	$(Q)$(CXX) -O2 $(call pkg,--cflags,geos) -o $@ $< $(PEERS_LIBS)
$(UNIT) $(TOOLS) $(BENCH) $(FUZZ): $(B)/%: $(B)/%.o
$(PROGRAM) $(UNIT) $(BENCH) $(FUZZ): $(LIB)
	$(SAY) "  LD  $@"
	$(Q)$(LINK) -o $@ $(filter %.o,$^) $(filter-out %.o $(LIB),$^) $(LIB) \
	  $(EXTRA_LIBS) $(LIBRARIES)

# They are started by the thousand, and are not what is tested.
$(call obj,$(TOOL_SRC)): EXTRA_CFLAGS = $(PLAIN)
$(TOOLS):
	$(SAY) "  LD  $@"
	$(Q)$(LINK) $(PLAIN) -o $@ $< $(LIBS) -lm

# Rewritten, and so newer than what depends on them, only when they change: the
# flags, and the list of objects, which shrinks when a source file is removed.
$(B)/flags: STAMP = $(COMPILE) : $(LDFLAGS) : $(LIBRARIES)
$(B)/objects: STAMP = $(LIB_OBJ) : $(UNIT_AUX)
$(B)/flags: $(B)/hardening
$(B)/flags $(B)/objects: FORCE
	@mkdir -p $(@D)
	@printf '%s\n' '$(subst ','\'',$(STAMP))' | cmp -s - $@ || \
	  printf '%s\n' '$(subst ','\'',$(STAMP))' >$@

# The flags it was found for, and those of HARDENING that go without a warning.
$(B)/hardening: FORCE
	@mkdir -p $(@D)
	@asked='$(subst ','\'',$(strip $(ALL_FLAGS) : $(HARDENING)))'; \
	  test "$$(sed 1q $@ 2>/dev/null)" = "$$asked" || { \
	  printf '#include <stdio.h>\nint main(void) { return puts("") < 0; }\n' \
	    >$@.c; printf '%s\n' "$$asked" >$@.new; for f in $(HARDENING); do \
	    $(CC) -Werror $$f $(CPPFLAGS) $(CFLAGS) $(VFLAGS_$(VARIANT)) -o $@.exe \
	      $@.c $(LDFLAGS) >/dev/null 2>&1 && echo $$f >>$@.new; done; \
	  rm -f $@.c $@.exe && mv $@.new $@; }

# One clear message in place of fifty about a missing header.
$(B)/libraries: $(B)/flags
	@printf '%s\n' '#include <gsl/gsl_version.h>' '#include <cjson/cJSON.h>' \
	  'int main(void) { return !gsl_version || !cJSON_Version(); }' >$@.c
	@$(LINK) $(GSL_CFLAGS) $(CJSON_CFLAGS) $(CPPFLAGS) -o $@.exe $@.c \
	  $(LIBRARIES) >$@.log 2>&1 || { cat $@.log >&2; echo >&2; \
	  echo 'phspline needs GSL and cJSON with their headers, and a C11' \
	    'compiler ($(CC)).' >&2; \
	  echo 'To install what is missing: make deps' >&2; exit 1; }
	@rm -f $@.exe && touch $@

-include $(OBJ:.o=.d)

# One file for machines without libraries: without figures and volumes.  Where
# there is no static cJSON, as on Debian, it is built from its source.
STATIC = VARIANT=static WITHOUT_CAIRO=1 WITHOUT_TEEM=1 LDFLAGS='-static $(LDFLAGS)'
static: ## one executable without shared libraries, build/static/phspline
	$(need)
	+@mkdir -p build/static; if printf '%s\n' '#include <cjson/cJSON.h>' \
	  'int main(void) { return !cJSON_Version(); }' | $(CC) -static -x c \
	  -o build/static/cjson.exe - -lcjson -lm 2>/dev/null; then \
	  $(AGAIN) $(STATIC) static-run; else \
	  sh $(S).ci/cjson-source build/static/cjson && \
	  $(CC) $(CFLAGS) -c -o build/static/cJSON.o build/static/cjson/cJSON.c && \
	  $(AGAIN) $(STATIC) CJSON_LIBS=build/static/cJSON.o static-run; fi
static-run: all
	@! readelf -d $(PROGRAM) | grep NEEDED
	@echo '{"points":[[0,0],[1,1],[2,0]]}' | $(PROGRAM) planar >/dev/null
	@ls -l $(PROGRAM)

# ---- install -----------------------------------------------------------------

# data/completions/FILE and where each shell looks for it
COMPLETIONS = $(foreach c,phspline.bash:bash-completion/completions/phspline \
	_phspline:zsh/site-functions/_phspline \
	phspline.fish:fish/vendor_completions.d/phspline.fish,\
	$(if $(wildcard $(S)data/completions/$(firstword $(subst :, ,$c))),$c))
mandest = $(DESTDIR)$(mandir)/man$(subst .,,$(suffix $1))
compsrc = $(S)data/completions/$(firstword $(subst :, ,$1))
compdest = $(DESTDIR)$(datadir)/$(lastword $(subst :, ,$1))
# the data of the manual's examples; the manual is told where they are
EXAMPLES = $(filter-out %.sh %.awk,$(wildcard $(addprefix $(S)data/,*.* README)))
SLURM = $(wildcard $(S)data/slurm/*)
exampledir = $(docdir)/examples/data
installdoc = sed 's|/usr/local/share/doc/phspline|$(docdir)|' $(S)$1 \
	>"$(mandest)/$(notdir $1)" && chmod 644 "$(mandest)/$(notdir $1)"
define newline


endef
install: all ## install below prefix=/usr/local (DESTDIR is respected)
	$(INSTALL) -d "$(DESTDIR)$(bindir)"
	$(INSTALL_PROGRAM) $(PROGRAM) "$(DESTDIR)$(bindir)/phspline"
	$(foreach m,$(MAN),$(INSTALL) -d "$(call mandest,$m)"$(newline)\
	  $(call installdoc,$m)$(newline))
	$(INSTALL) -d "$(DESTDIR)$(exampledir)"
	$(INSTALL_DATA) $(EXAMPLES) "$(DESTDIR)$(exampledir)"
	$(INSTALL) -d "$(DESTDIR)$(exampledir)/slurm"
	$(INSTALL_DATA) $(SLURM) "$(DESTDIR)$(exampledir)/slurm"
	$(foreach c,$(COMPLETIONS),\
	  $(INSTALL) -d "$$(dirname "$(call compdest,$c)")"$(newline)\
	  $(INSTALL_DATA) $(call compsrc,$c) "$(call compdest,$c)"$(newline))

uninstall: ## remove what install put there
	rm -f "$(DESTDIR)$(bindir)/phspline"
	$(foreach m,$(MAN),rm -f "$(call mandest,$m)/$(notdir $m)"$(newline))
	$(foreach c,$(COMPLETIONS),rm -f "$(call compdest,$c)"$(newline))
	rm -f $(foreach f,$(EXAMPLES),"$(DESTDIR)$(exampledir)/$(notdir $f)") \
	  $(foreach f,$(SLURM),"$(DESTDIR)$(exampledir)/slurm/$(notdir $f)")
	@$(foreach d,$(bindir) $(sort $(foreach m,$(MAN),$(call mandest,$m)) \
	  $(foreach c,$(COMPLETIONS),$(dir $(call compdest,$c)))) $(exampledir)/slurm,\
	  (cd "$(DESTDIR)/" && rmdir -p ".$(patsubst $(DESTDIR)%,%,$d)") \
	    2>/dev/null || :;)

# ---- packages ----------------------------------------------------------------
# Targets that may install come in pairs: X gets the packages, then starts make
# again for X-run, because pkg-config may be one of the packages and every flag
# above has to be asked for anew.  Plain `make' never installs anything.

deps: ## install missing packages (DEPS="SET...", see the script)
	@sh $(S).ci/install-packages $(DEPS)

need = @sh $(S).ci/install-packages build
# what a run can do without may stay missing, loudly
may_need = $(if $(strip $1),@sh $(S).ci/install-packages $1 || \
	echo 'make: going on; what needs it is skipped' >&2)

# ---- tests -------------------------------------------------------------------

RUN = env CC='$(CC)' COMPILE='$(subst ','\'',$(COMPILE))' builddir=$(B) \
	TEST_JOBS='$(TEST_JOBS)' sh $(S)tests/run
HAVE_CHECK = $(shell echo 'TTest t;' \
	'int main(void) { srunner_run_all(0, CK_ENV); }' | \
	$(CC) $(CHECK_CFLAGS) -include check.h -x c - -o /dev/null \
	$(LDFLAGS) $(CHECK_LIBS) $(LIBS) -pthread -lm 2>/dev/null && echo yes)
# no Check, no unit tests: tests/run is told so, and tells it
UNIT_WANTED := $(if $(filter %-run tests-build,$(MAKECMDGOALS)),\
	$(if $(HAVE_CHECK),$(UNIT),--no-check))
# `make check TESTS=tests/cli/smoke.t' runs less; a unit test is its source
TESTS =
pick = $(if $(TESTS),$(filter $(TESTS:.c=) $(addprefix %/,$(TESTS:.c=)),$1),$1)

tests-build: all $(TOOLS) $(call pick,$(filter-out --%,$(UNIT_WANTED)))

# what a compiler says of tests and benchmarks, without code: a tenth of the time
tests-syntax: $(B)/libraries
	$(Q)$(COMPILE) -I$(S)tests/unit -Wno-double-promotion $(CHECK_CFLAGS) \
	  -fsyntax-only $(addprefix $(S),$(UNIT_SRC) $(TOOL_SRC) \
	  $(filter-out %_ipopt.c,$(BENCH_SRC)))

check: ## unit and command line tests, quick lints (or TESTS=FILE...)
	$(need)
	$(call may_need,test $(PLOT))
	$(SUBMAKE) check-run
check-run: tests-build
	@$(RUN) $(call pick,$(addprefix $(S),$(CLI_TESTS) $(QUICK_LINTS)) \
	  $(UNIT_WANTED))

demo: ## build, then run data/demo.sh
	$(need)
	$(call may_need,$(PLOT))
	$(SUBMAKE) demo-run
demo-run: all
	@sh $(S)data/demo.sh $(PROGRAM)

# In the source directory, where two of them are kept for README.
figures: ## draw the figures of the manual in data/figures/
	$(need)
	$(call may_need,$(PLOT))
	$(SUBMAKE) figures-run
figures-run: all
	@sh $(S)data/figures.sh $(PROGRAM)

# CK_FORK=no: leaks in forked children would go unreported.
asan: ## the tests under the address and undefined sanitizers
	$(need)
	$(call may_need,test $(PLOT))
	$(SUBMAKE) VARIANT=asan asan-run
asan-run: tests-build
	@CK_FORK=no PH_SHORT=$(SHORT) LSAN_OPTIONS='suppressions=$(abspath \
	  $(srcdir)/tests/suppress/lsan):print_suppressions=0' $(RUN) $(call pick,\
	  $(addprefix $(S),$(FAULT_TESTS) $(CLI_TESTS)) $(UNIT_WANTED))

tsan: ## unit tests and tests/cli/jobs.t under the thread sanitizer
	$(need)
	$(call may_need,test $(PLOT))
	$(SUBMAKE) VARIANT=tsan tsan-run
# Without setarch -R its fixed shadow map can collide with randomised addresses.
tsan-run: tests-build
	@CK_FORK=no PH_SHORT=1 $$(setarch -R true 2>/dev/null && echo setarch -R) \
	  $(RUN) $(call pick,$(UNIT_WANTED) $(addprefix $(S),$(filter \
	  %/jobs.t,$(CLI_TESTS))))

# Addresses and leaks are what asan is for, and of more of the tests; here it is
# memory that is read before it is written: the program with every command, and
# what reads and writes texts.
VALGRIND_UNIT = $(filter-out $(addprefix $(B)/tests/,prop/% unit/kernel/% \
	unit/curve/% unit/solve/% unit/check/%),$(UNIT_WANTED))
valgrind: ## smoke.t, data/, growth, units of input and output under valgrind
	$(need)
	$(call may_need,test valgrind $(PLOT))
	$(SUBMAKE) valgrind-run
valgrind-run: all $(TOOLS) $(filter-out --%,$(VALGRIND_UNIT))
	@printf '#!/bin/sh\nexec %s "%s" "$$@"\n' '$(VALGRIND)' \
	  '$(CURDIR)/$(PROGRAM)' >$(PROGRAM).valgrind && chmod +x $(PROGRAM).valgrind
	@CK_FORK=no PH_SHORT=1 PH_WRAP='$(VALGRIND)' PHSPLINE=$(PROGRAM).valgrind $(RUN) \
	  $(addprefix $(S),tests/valgrind/data.t tests/valgrind/growth.t \
	  $(filter %/smoke.t,$(CLI_TESTS))) \
	  $(VALGRIND_UNIT)

coverage: ## the tests, then the lines of each source file they executed
	$(need)
	$(call may_need,test $(PLOT))
	$(SUBMAKE) VARIANT=cov coverage-run
coverage-run: tests-build
	@find $(B) -name '*.gcda' -exec rm -f {} +
	@CK_FORK=no $(RUN) $(UNIT_WANTED) $(addprefix $(S),$(CLI_TESTS))
	@for o in $(LIB_OBJ) $(MAIN_OBJ); do $(GCOV) -n -o $$o $$o 2>&1; done | \
	  awk -f $(S).ci/coverage.awk

lint: ## all of tests/lint/: layers, format, manual, scripts, ...
	$(need)
	$(call may_need,lint)
	$(SUBMAKE) lint-run
lint-run: all
	@$(RUN) $(addprefix $(S),$(LINTS))

# Committed inputs are read, new ones kept below build/.
fuzz: ## each fuzz target, TEST_JOBS at once, for FUZZ_TIME=60 seconds
	$(need)
	+@if sh $(S).ci/install-packages clang; then \
	  $(AGAIN) CC=clang VARIANT=fuzz fuzz-run; \
	else echo 'SKIPPED: fuzzing needs clang and its runtime' \
	  '(Debian: clang, libclang-rt-14-dev)'; fi
fuzz-run: $(call pick,$(FUZZ))
	@FUZZ_TIME=$(FUZZ_TIME) FUZZ_SEED=$(FUZZ_SEED) PH_TIMEOUT=$$(($(FUZZ_TIME) + 600)) \
	  PH_WRAP='sh tests/fuzz/run' $(RUN) $(call pick,$(FUZZ))

# Problems are solved and verified by tests/prop/t_verify.c, in TEST_JOBS
# threads; what fails is printed as a command line, counts as it goes.  The
# other property tests take ten times as many data as in check.
TRIALS = 1000000
SEED = 1
check-long: ## a million random problems verified, properties, a conjecture
	$(need)
	$(call may_need,test)
	$(SUBMAKE) check-long-run
LONG = $(filter-out %/t_verify,$(filter $(B)/tests/prop/%,$(UNIT))) \
	$(addprefix $(S),$(LONG_TESTS))
check-long-run: $(B)/bench/conjecture $(B)/tests/prop/t_verify $(LONG) all
	@$(B)/bench/conjecture $(TRIALS) $(SEED)
	@PH_LONG=1 PH_SEED=$(SEED) PH_TIMEOUT=3600 $(RUN) $(LONG)
	@PH_TRIALS=$(TRIALS) PH_SEED=$(SEED) PH_JOBS=$(TEST_JOBS) CK_FORK=no \
	  $(B)/tests/prop/t_verify

# MEMBERS of each family of random data, or of those whose names contain FAMILY
MEMBERS = 20
FAMILY =
check-rates: ## how often random data are solved, and how time grows with size
	$(need)
	$(SUBMAKE) check-rates-run
check-rates-run: all
	@python3 $(S)bench/rates.py $(PROGRAM) --members=$(MEMBERS) \
	  --seed=$(SEED) $(if $(INSTRUCTIONS),--instructions) $(if $(FAMILY),'$(FAMILY)')

# make, GNU parallel, ssh and Slurm, started on this machine.
check-cluster: ## runs in parts by make, parallel, ssh and Slurm, also killed
	$(need)
	$(call may_need,cluster)
	$(SUBMAKE) check-cluster-run
check-cluster-run: all
	@srcdir=$(srcdir) sh $(S)tests/cluster/check.sh $(PROGRAM)

# bench/run names the PARTS; with all of them the tables go into a file
bench: ## run the benchmarks, into bench/RESULTS.md; PARTS=... shows some
	$(need)
	$(call may_need,$(PLOT))
	$(SUBMAKE) bench-run
bench-run: all $(BENCH) $(if $(PEERS_LIBS),$(B)/bench/trim_peers)
	@$(if $(PARTS),sh $(S)bench/run $(B) $(PARTS),CC='$(CC)' \
	  CFLAGS='$(CFLAGS)' sh $(S)bench/results $(B) $(S)bench/RESULTS.md)

# ---- release -----------------------------------------------------------------
# The tarball holds what git tracks, plus configure; made from an unpacked
# tarball it comes out the same, byte for byte, as distcheck demands.

configure: ## make ./configure with autoconf
	cd $(srcdir) && autoconf

dist: ## make phspline-VERSION.tar.gz
	$(call may_need,dist)
	@sh $(S).ci/dist make $(DIST)

distcheck: dist ## prove the tarball: read-only, out of tree, install, again
	@MAKE='$(MAKE)' sh $(S).ci/dist check $(DIST) $(DISTCHECK_TARGETS)

clean: ## remove build/ and what the demo wrote
	rm -rf build demo-output

deb: ## make phspline_VERSION_ARCHITECTURE.deb, a Debian package
	@sh $(S).ci/install-packages build plot volume deb
	$(SUBMAKE) all
	@MAKE='$(MAKE)' sh $(S).ci/deb make $(VERSION)

check-deb: deb ## ... and install it where nothing else is (root, debootstrap)
	@sh $(S).ci/install-packages check-deb
	@sh $(S).ci/deb check $(VERSION)

distclean: clean ## ... and what configure and dist made
	rm -rf autom4te.cache phspline-*.tar.gz
	rm -f config.mk config.log config.status
	$(if $(S),rm -f Makefile)

help: ## this list
	@echo 'phspline $(VERSION): make TARGET [VARIABLE=VALUE]...'
	@sed -n 's/^\([a-z-]*\):.*## \(.*\)/  \1 \2/p' $(S)Makefile | \
	  while read -r t d; do printf '  %-11s %s\n' "$$t" "$$d"; done
	@echo 'Variables: CC CFLAGS CPPFLAGS LDFLAGS prefix DESTDIR WERROR=1 V=1' \
	  'WITHOUT_CAIRO=1 WITHOUT_TEEM=1 WITHOUT_EXPAT=1'
