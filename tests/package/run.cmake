# One way of embedding, WAY; see CMakeLists.txt for the other variables.
set(embedder ${SOURCE_DIR}/tests/package/embedder)
set(prefix ${WORK_DIR}/prefix)
set(build ${WORK_DIR}/${WAY})
set(settings
    -G ${GENERATOR}
    -D CMAKE_CXX_COMPILER=${COMPILER}
    -D CMAKE_CXX_FLAGS=${FLAGS}
    -D CMAKE_BUILD_TYPE=${CONFIG})

# For builds of the library itself, which take long: what is tested is how it is embedded, not how
# fast it is.
set(quick)
if(NOT COMPILER MATCHES "/(clang-)?cl(\\.exe)?$")
    string(TOUPPER "${CONFIG}" config)
    set(quick -D "CMAKE_CXX_FLAGS_${config}=-O0 -g0")
endif()

function(run)
    execute_process(COMMAND ${ARGV}
        RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
    if(NOT result EQUAL 0)
        string(REPLACE ";" " " command "${ARGV}")
        message(FATAL_ERROR "${command}\nended with ${result}:\n${output}")
    endif()
    set(output ${output} PARENT_SCOPE)
endfunction()

function(expect_embedder_works program)
    run(${program})
    string(STRIP "${output}" output)
    set(expected "2 units, 1 diagnostics")
    if(NOT output STREQUAL expected)
        message(FATAL_ERROR "${program} printed `${output}`, not `${expected}`")
    endif()
    message(STATUS "${WAY}: ${output}")
endfunction()

# Builds the embedder in `folder` by CMake, the further arguments telling it where iecfront is.
function(try_cmake folder)
    run(${CMAKE_COMMAND} -S ${embedder} -B ${folder} ${settings} ${ARGN})
    run(${CMAKE_COMMAND} --build ${folder} --config ${CONFIG})
    find_program(program embedder PATHS ${folder} ${folder}/${CONFIG} NO_DEFAULT_PATH NO_CACHE
        REQUIRED)
    expect_embedder_works(${program})
endfunction()

# Builds the embedder by a plain compiler command with what pkg-config says about `where`.
function(try_pkg_config where folder)
    find_program(pkg_config NAMES pkg-config pkgconf)
    if(NOT pkg_config)
        message(STATUS "skipped: pkg-config is not installed")
        return()
    endif()
    set(ENV{PKG_CONFIG_PATH} ${where}/${LIBRARY_DIR}/pkgconfig)
    run(${pkg_config} --print-errors --validate iecfront)
    run(${pkg_config} --cflags --libs iecfront)
    separate_arguments(options UNIX_COMMAND "${output}")
    separate_arguments(flags UNIX_COMMAND "${FLAGS}")
    file(MAKE_DIRECTORY ${folder})
    run(${COMPILER} -std=c++20 ${flags} ${embedder}/main.cpp -o ${folder}/embedder ${options})
    set(ENV{LD_LIBRARY_PATH} ${where}/${LIBRARY_DIR})
    set(ENV{DYLD_LIBRARY_PATH} ${where}/${LIBRARY_DIR})
    expect_embedder_works(${folder}/embedder)
endfunction()

file(REMOVE_RECURSE ${build})

if(WAY STREQUAL "install")
    file(REMOVE_RECURSE ${prefix})
    # Another prefix than the configured one, so that whatever holds a path of its own is found out.
    run(${CMAKE_COMMAND} --install ${MAIN_BUILD_DIR} --config ${CONFIG} --prefix ${prefix})

elseif(WAY STREQUAL "find_package")
    try_cmake(${build} -D CMAKE_PREFIX_PATH=${prefix})

elseif(WAY STREQUAL "pkg_config")
    try_pkg_config(${prefix} ${build})

elseif(WAY STREQUAL "add_subdirectory")
    try_cmake(${build} -D IECFRONT_SOURCE_DIR=${SOURCE_DIR} ${quick})

elseif(WAY STREQUAL "shared")
    run(${CMAKE_COMMAND} -S ${SOURCE_DIR} -B ${build}/library ${settings} ${quick}
        -D BUILD_SHARED_LIBS=ON
        -D IECFRONT_BUILD_CLI=OFF -D IECFRONT_BUILD_TESTS=OFF -D IECFRONT_BUILD_EXAMPLES=OFF)
    run(${CMAKE_COMMAND} --build ${build}/library --config ${CONFIG})
    run(${CMAKE_COMMAND} --install ${build}/library --config ${CONFIG} --prefix ${build}/prefix)
    try_cmake(${build}/find_package -D CMAKE_PREFIX_PATH=${build}/prefix)
    try_pkg_config(${build}/prefix ${build}/pkg_config)
endif()
