# The two commands of the README; developers may use the CMake presets directly.
.PHONY: all demo test lint package install clean

PRESET ?= release
BUILD := build/$(PRESET)

all: build

.PHONY: dependencies build
dependencies:
	@deploy/install_dependencies.sh

build: dependencies
	@cmake --preset $(PRESET)
	@cmake --build --preset $(PRESET)

# Generated frames, or real ones: make demo FRAME=DIR/NAME [INTRINSICS=FX,FY,CX,CY]
demo: build
	@deploy/demo.sh $(BUILD)

test: build
	@ctest --preset $(PRESET) -j 2

lint: dependencies
	@deploy/lint.sh $(BUILD)

# Debian packages of the server, the clients and the libraries, in $(BUILD)
package: build
	@cd $(BUILD) && cpack

# Below PREFIX, /usr/local unless given; needs to be root for that
install: build
	@cmake --install $(BUILD) $(if $(PREFIX),--prefix $(PREFIX))

clean:
	rm -rf build demo
