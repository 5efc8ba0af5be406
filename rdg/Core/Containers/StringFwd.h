// Forward declarations of strings under their engine header. Source: engine Containers/StringFwd.h.
#pragma once

#include "Containers/ContainersFwd.h"
