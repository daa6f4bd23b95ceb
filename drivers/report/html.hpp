#pragma once

#include "drivers/base/base64.hpp"
#include "drivers/report/page.hpp"
