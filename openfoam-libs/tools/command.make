# For check-release (make, read after wmake's makefiles/general): prints what a source of this library is compiled with

.PHONY: compile-command
compile-command: ; $(info $(CC) $(c++FLAGS))@:
