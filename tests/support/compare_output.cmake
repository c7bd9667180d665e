# Runs PROGRAM with ARGUMENTS and compares what it prints with the file EXPECTED. With UPDATE_EXPECT=1
# in the environment the file is written instead. When STATUS is set, PROGRAM has to end with it.
execute_process(COMMAND ${PROGRAM} ${ARGUMENTS}
    OUTPUT_VARIABLE output ERROR_VARIABLE errors RESULT_VARIABLE result)
if(NOT result MATCHES "^[0-9]+$")
    message(FATAL_ERROR "${PROGRAM} ended badly: ${result}\n${errors}")
endif()
if(DEFINED STATUS AND NOT result EQUAL STATUS)
    message(FATAL_ERROR "${PROGRAM} ended with ${result}, not with ${STATUS}\n${errors}")
endif()
if("$ENV{UPDATE_EXPECT}" STREQUAL "1")
    file(WRITE ${EXPECTED} "${output}")
    return()
endif()
file(READ ${EXPECTED} expected)
if(NOT output STREQUAL expected)
    message(FATAL_ERROR
        "${PROGRAM} printed\n----\n${output}----\nbut ${EXPECTED} holds\n----\n${expected}----\n${errors}")
endif()
