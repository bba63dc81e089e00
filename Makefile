# The two commands of the README; developers may use the CMake presets directly.
.PHONY: all demo test lint check-long package install clean

PRESET ?= release
BUILD := build/$(PRESET)

all: build

.PHONY: dependencies configured build
dependencies:
	@deploy/install_dependencies.sh

configured: dependencies
	@cmake --preset $(PRESET)

build: configured
	@cmake --build --preset $(PRESET)

# Generated frames, or real ones: make demo FRAME=DIR/NAME [INTRINSICS=FX,FY,CX,CY]; the page that it
# may show is built once there is a picture to look at.
demo: configured
	@cmake --build --preset $(PRESET) --target fovea-server fovea
	@deploy/demo.sh $(BUILD)

# Some tests wait more than they compute.
test: build
	@ctest --preset $(PRESET) -j $$(( $$(nproc) + 2 ))

lint: dependencies
	@deploy/lint.sh $(BUILD)

# Sanitizers, fuzzing and the contract: an hour and more; PART=asan, tsan, fuzz or buf for one
check-long: dependencies
	@deploy/check_long.sh $(PART)

# Debian packages of the server, the clients and the libraries, in $(BUILD) in place of older ones
package: build
	@rm -f $(BUILD)/*.deb
	@umask 022 && cd $(BUILD) && cpack

# Below PREFIX, and nothing else; /usr/local unless given, which needs root. For others, too: the
# server's own user has to read its configuration.
install: build
	@umask 022 && cmake --install $(BUILD) $(if $(PREFIX),--prefix $(subst $() ,\ ,$(PREFIX)))

clean:
	rm -rf build demo
