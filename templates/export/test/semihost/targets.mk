# Included by the Makefile at the top: the tests on a bare Cortex-M4F and Cortex-M7 under QEMU.
.PHONY: check-m4 check-m7

check-m4:
	$(MAKE) -C test/semihost run CPU=cortex-m4

check-m7:
	$(MAKE) -C test/semihost run CPU=cortex-m7
