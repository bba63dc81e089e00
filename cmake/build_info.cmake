# Writes OUTPUT from INPUT with VERSION and COMMIT, where it would change. COMMIT is what SOURCE is a
# checkout of, unless it is given. Run with cmake -P at each build: commits come without a configure.
if(NOT COMMIT)
  execute_process(
    COMMAND git -C ${SOURCE} describe --always --dirty=-modified --abbrev=12 --exclude=*
    OUTPUT_VARIABLE COMMIT OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
  if(NOT COMMIT)
    set(COMMIT unknown)
  endif()
endif()
configure_file(${INPUT} ${OUTPUT} @ONLY)
