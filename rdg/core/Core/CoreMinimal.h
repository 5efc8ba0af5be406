// Includes what nearly every file of the engine needs: basic types, containers, strings, pointers, mathematics,
// delegates, logging and console variables. `check`, `verify` and `ensure` are macros, so third-party headers come
// before this one. Source: engine CoreMinimal.h.
#pragma once

#include "CoreGlobals.h"
#include "CoreTypes.h"
#include "Misc/AssertionMacros.h"
#include "Misc/EnumClassFlags.h"
#include "Misc/Optional.h"
#include "Misc/ScopeLock.h"

#include "HAL/IConsoleManager.h"
#include "HAL/PlatformTime.h"
#include "HAL/UnrealMemory.h"

#include "Delegates/Delegate.h"
#include "Logging/LogMacros.h"
#include "Stats/Stats.h"
#include "UObject/NameTypes.h"

#include "Templates/Function.h"
#include "Templates/RefCounting.h"
#include "Templates/SharedPointer.h"
#include "Templates/Tuple.h"
#include "Templates/TypeHash.h"
#include "Templates/UniquePtr.h"
#include "Templates/UnrealTemplate.h"

#include "Containers/Array.h"
#include "Containers/ArrayView.h"
#include "Containers/BitArray.h"
#include "Containers/Map.h"
#include "Containers/Set.h"
#include "Containers/StaticArray.h"
#include "Containers/UnrealString.h"

#include "Math/Box.h"
#include "Math/Color.h"
#include "Math/IntPoint.h"
#include "Math/IntRect.h"
#include "Math/IntVector.h"
#include "Math/Matrix.h"
#include "Math/Quat.h"
#include "Math/Rotator.h"
#include "Math/UnrealMathUtility.h"
#include "Math/Vector.h"
#include "Math/Vector2D.h"
#include "Math/Vector4.h"
