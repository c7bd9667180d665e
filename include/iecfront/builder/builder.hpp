#pragma once

/// All of the builder.
#include <iecfront/builder/changes.hpp>
#include <iecfront/builder/configuration.hpp>
#include <iecfront/builder/constants.hpp>
#include <iecfront/builder/il.hpp>
#include <iecfront/builder/part.hpp>
#include <iecfront/builder/pous.hpp>
#include <iecfront/builder/sfc.hpp>
#include <iecfront/builder/st.hpp>
#include <iecfront/builder/tree.hpp>
#include <iecfront/builder/types.hpp>
#include <iecfront/builder/variables.hpp>
