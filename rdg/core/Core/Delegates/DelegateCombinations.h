// The macros that name delegate types, for up to nine parameters. Source: engine Delegates/DelegateCombinations.h.
#pragma once

#define FUNC_DECLARE_DELEGATE(Name, ReturnType, ...) typedef TDelegate<ReturnType(__VA_ARGS__)> Name;
#define FUNC_DECLARE_MULTICAST_DELEGATE(Name, ...) typedef TMulticastDelegate<void(__VA_ARGS__)> Name;
/** In the engine only the owner may broadcast an event; here it is a multicast delegate. */
#define FUNC_DECLARE_EVENT(OwningType, Name, ...) typedef TMulticastDelegate<void(__VA_ARGS__)> Name;

#define DECLARE_DELEGATE(Name) FUNC_DECLARE_DELEGATE(Name, void)
#define DECLARE_MULTICAST_DELEGATE(Name) FUNC_DECLARE_MULTICAST_DELEGATE(Name)
#define DECLARE_TS_MULTICAST_DELEGATE(Name) FUNC_DECLARE_MULTICAST_DELEGATE(Name)
#define DECLARE_EVENT(OwningType, Name) FUNC_DECLARE_EVENT(OwningType, Name)
#define DECLARE_DELEGATE_RetVal(ReturnType, Name) FUNC_DECLARE_DELEGATE(Name, ReturnType)

#define DECLARE_DELEGATE_OneParam(Name, ...) FUNC_DECLARE_DELEGATE(Name, void, __VA_ARGS__)
#define DECLARE_DELEGATE_RetVal_OneParam(ReturnType, Name, ...) FUNC_DECLARE_DELEGATE(Name, ReturnType, __VA_ARGS__)
#define DECLARE_MULTICAST_DELEGATE_OneParam(Name, ...) FUNC_DECLARE_MULTICAST_DELEGATE(Name, __VA_ARGS__)
#define DECLARE_TS_MULTICAST_DELEGATE_OneParam(Name, ...) FUNC_DECLARE_MULTICAST_DELEGATE(Name, __VA_ARGS__)
#define DECLARE_EVENT_OneParam(OwningType, Name, ...) FUNC_DECLARE_EVENT(OwningType, Name, __VA_ARGS__)

#define DECLARE_DELEGATE_TwoParams(Name, ...) FUNC_DECLARE_DELEGATE(Name, void, __VA_ARGS__)
#define DECLARE_DELEGATE_RetVal_TwoParams(ReturnType, Name, ...) FUNC_DECLARE_DELEGATE(Name, ReturnType, __VA_ARGS__)
#define DECLARE_MULTICAST_DELEGATE_TwoParams(Name, ...) FUNC_DECLARE_MULTICAST_DELEGATE(Name, __VA_ARGS__)
#define DECLARE_TS_MULTICAST_DELEGATE_TwoParams(Name, ...) FUNC_DECLARE_MULTICAST_DELEGATE(Name, __VA_ARGS__)
#define DECLARE_EVENT_TwoParams(OwningType, Name, ...) FUNC_DECLARE_EVENT(OwningType, Name, __VA_ARGS__)

#define DECLARE_DELEGATE_ThreeParams(Name, ...) FUNC_DECLARE_DELEGATE(Name, void, __VA_ARGS__)
#define DECLARE_DELEGATE_RetVal_ThreeParams(ReturnType, Name, ...) FUNC_DECLARE_DELEGATE(Name, ReturnType, __VA_ARGS__)
#define DECLARE_MULTICAST_DELEGATE_ThreeParams(Name, ...) FUNC_DECLARE_MULTICAST_DELEGATE(Name, __VA_ARGS__)
#define DECLARE_TS_MULTICAST_DELEGATE_ThreeParams(Name, ...) FUNC_DECLARE_MULTICAST_DELEGATE(Name, __VA_ARGS__)
#define DECLARE_EVENT_ThreeParams(OwningType, Name, ...) FUNC_DECLARE_EVENT(OwningType, Name, __VA_ARGS__)

#define DECLARE_DELEGATE_FourParams(Name, ...) FUNC_DECLARE_DELEGATE(Name, void, __VA_ARGS__)
#define DECLARE_DELEGATE_RetVal_FourParams(ReturnType, Name, ...) FUNC_DECLARE_DELEGATE(Name, ReturnType, __VA_ARGS__)
#define DECLARE_MULTICAST_DELEGATE_FourParams(Name, ...) FUNC_DECLARE_MULTICAST_DELEGATE(Name, __VA_ARGS__)
#define DECLARE_TS_MULTICAST_DELEGATE_FourParams(Name, ...) FUNC_DECLARE_MULTICAST_DELEGATE(Name, __VA_ARGS__)
#define DECLARE_EVENT_FourParams(OwningType, Name, ...) FUNC_DECLARE_EVENT(OwningType, Name, __VA_ARGS__)

#define DECLARE_DELEGATE_FiveParams(Name, ...) FUNC_DECLARE_DELEGATE(Name, void, __VA_ARGS__)
#define DECLARE_DELEGATE_RetVal_FiveParams(ReturnType, Name, ...) FUNC_DECLARE_DELEGATE(Name, ReturnType, __VA_ARGS__)
#define DECLARE_MULTICAST_DELEGATE_FiveParams(Name, ...) FUNC_DECLARE_MULTICAST_DELEGATE(Name, __VA_ARGS__)
#define DECLARE_TS_MULTICAST_DELEGATE_FiveParams(Name, ...) FUNC_DECLARE_MULTICAST_DELEGATE(Name, __VA_ARGS__)
#define DECLARE_EVENT_FiveParams(OwningType, Name, ...) FUNC_DECLARE_EVENT(OwningType, Name, __VA_ARGS__)

#define DECLARE_DELEGATE_SixParams(Name, ...) FUNC_DECLARE_DELEGATE(Name, void, __VA_ARGS__)
#define DECLARE_DELEGATE_RetVal_SixParams(ReturnType, Name, ...) FUNC_DECLARE_DELEGATE(Name, ReturnType, __VA_ARGS__)
#define DECLARE_MULTICAST_DELEGATE_SixParams(Name, ...) FUNC_DECLARE_MULTICAST_DELEGATE(Name, __VA_ARGS__)
#define DECLARE_TS_MULTICAST_DELEGATE_SixParams(Name, ...) FUNC_DECLARE_MULTICAST_DELEGATE(Name, __VA_ARGS__)
#define DECLARE_EVENT_SixParams(OwningType, Name, ...) FUNC_DECLARE_EVENT(OwningType, Name, __VA_ARGS__)

#define DECLARE_DELEGATE_SevenParams(Name, ...) FUNC_DECLARE_DELEGATE(Name, void, __VA_ARGS__)
#define DECLARE_DELEGATE_RetVal_SevenParams(ReturnType, Name, ...) FUNC_DECLARE_DELEGATE(Name, ReturnType, __VA_ARGS__)
#define DECLARE_MULTICAST_DELEGATE_SevenParams(Name, ...) FUNC_DECLARE_MULTICAST_DELEGATE(Name, __VA_ARGS__)
#define DECLARE_TS_MULTICAST_DELEGATE_SevenParams(Name, ...) FUNC_DECLARE_MULTICAST_DELEGATE(Name, __VA_ARGS__)
#define DECLARE_EVENT_SevenParams(OwningType, Name, ...) FUNC_DECLARE_EVENT(OwningType, Name, __VA_ARGS__)

#define DECLARE_DELEGATE_EightParams(Name, ...) FUNC_DECLARE_DELEGATE(Name, void, __VA_ARGS__)
#define DECLARE_DELEGATE_RetVal_EightParams(ReturnType, Name, ...) FUNC_DECLARE_DELEGATE(Name, ReturnType, __VA_ARGS__)
#define DECLARE_MULTICAST_DELEGATE_EightParams(Name, ...) FUNC_DECLARE_MULTICAST_DELEGATE(Name, __VA_ARGS__)
#define DECLARE_TS_MULTICAST_DELEGATE_EightParams(Name, ...) FUNC_DECLARE_MULTICAST_DELEGATE(Name, __VA_ARGS__)
#define DECLARE_EVENT_EightParams(OwningType, Name, ...) FUNC_DECLARE_EVENT(OwningType, Name, __VA_ARGS__)

#define DECLARE_DELEGATE_NineParams(Name, ...) FUNC_DECLARE_DELEGATE(Name, void, __VA_ARGS__)
#define DECLARE_DELEGATE_RetVal_NineParams(ReturnType, Name, ...) FUNC_DECLARE_DELEGATE(Name, ReturnType, __VA_ARGS__)
#define DECLARE_MULTICAST_DELEGATE_NineParams(Name, ...) FUNC_DECLARE_MULTICAST_DELEGATE(Name, __VA_ARGS__)
#define DECLARE_TS_MULTICAST_DELEGATE_NineParams(Name, ...) FUNC_DECLARE_MULTICAST_DELEGATE(Name, __VA_ARGS__)
#define DECLARE_EVENT_NineParams(OwningType, Name, ...) FUNC_DECLARE_EVENT(OwningType, Name, __VA_ARGS__)
