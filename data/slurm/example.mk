# SPDX-License-Identifier: GPL-3.0-or-later
#
# A run in parts by make, which repeats what is missing and nothing else:
#
#   make -j 8 -f example.mk N=100 COMMAND=planar FILES=problems.jsonl OUT=results
#
# HERE is where part and merge are.
N = 8
COMMAND = planar
OPTIONS =
FILES = problems.jsonl
OUT = results
HERE = $(patsubst %/,%,$(dir $(lastword $(MAKEFILE_LIST))))
PARTS := $(shell k=0; while [ $$k -lt $(N) ]; do \
	echo $(OUT).$$k-of-$(N); k=$$((k + 1)); done)

$(OUT): $(PARTS)
	sh $(HERE)/merge $(N) $@

$(OUT).%-of-$(N): $(FILES)
	sh $(HERE)/part $* $(N) $(OUT) $(COMMAND) --jobs=1 --quiet \
	  $(OPTIONS) $(FILES)
