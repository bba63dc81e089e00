# Run by cpack: packages of a later commit are newer ones. Of two that have one version, apt takes
# the second one for installed.
set(ENV{TZ} UTC)
execute_process(
  COMMAND git -C ${CMAKE_CURRENT_LIST_DIR} log -1 --date=format-local:%Y%m%d%H%M%S --abbrev=12
          --format=+%cd.%h
  OUTPUT_VARIABLE commit OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
string(APPEND CPACK_DEBIAN_PACKAGE_RELEASE "${commit}")
