// What boards write by.
#pragma once

#include <board/console.hpp>
