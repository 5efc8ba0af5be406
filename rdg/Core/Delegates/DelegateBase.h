// Delegates under their engine header. Source: engine Delegates/DelegateBase.h.
#pragma once

#include "Delegates/Delegate.h"
