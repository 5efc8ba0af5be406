// Dynamic delegates: in the engine those that blueprints bind by a function's name; here they bind as others do.
// Source: engine UObject/ScriptDelegates.h, Delegates/DelegateCombinations.h.
#pragma once

#include "Delegates/Delegate.h"

#define DECLARE_DYNAMIC_MULTICAST_DELEGATE(DelegateName) using DelegateName = TMulticastDelegate<void()>;
#define DECLARE_DYNAMIC_MULTICAST_DELEGATE_OneParam(DelegateName, Type1, Name1) \
	using DelegateName = TMulticastDelegate<void(Type1)>;
#define DECLARE_DYNAMIC_MULTICAST_DELEGATE_TwoParams(DelegateName, Type1, Name1, Type2, Name2) \
	using DelegateName = TMulticastDelegate<void(Type1, Type2)>;
#define DECLARE_DYNAMIC_MULTICAST_DELEGATE_ThreeParams(DelegateName, Type1, Name1, Type2, Name2, Type3, Name3) \
	using DelegateName = TMulticastDelegate<void(Type1, Type2, Type3)>;

#define DECLARE_DYNAMIC_DELEGATE(DelegateName) using DelegateName = TDelegate<void()>;
#define DECLARE_DYNAMIC_DELEGATE_OneParam(DelegateName, Type1, Name1) using DelegateName = TDelegate<void(Type1)>;
#define DECLARE_DYNAMIC_DELEGATE_TwoParams(DelegateName, Type1, Name1, Type2, Name2) \
	using DelegateName = TDelegate<void(Type1, Type2)>;

/** `OnChanged.AddDynamic(this, &UMyObject::HandleChange)`. */
#define AddDynamic(Object, Function) AddUObject(Object, Function)
#define BindDynamic(Object, Function) BindUObject(Object, Function)
/** All bindings of the object: the engine removes that of the function. */
#define RemoveDynamic(Object, Function) RemoveAll(Object)
