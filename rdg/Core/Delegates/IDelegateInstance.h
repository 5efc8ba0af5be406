// Delegate handles under their engine header. Source: engine Delegates/IDelegateInstance.h.
#pragma once

#include "Delegates/Delegate.h"
