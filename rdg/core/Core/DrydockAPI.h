// The one export macro. The libraries are built with hidden visibility; what outside code, tests and compiled shaders
// use is marked with it. It stays "default" for users too, so that exceptions and RTTI match across shared objects.
#pragma once

#define DRYDOCK_API __attribute__((visibility("default")))

/** On a function of the engine that is absent here: calling it is a compile error with these words. */
#define DRYDOCK_ABSENT(Name, WayRound) __attribute__((unavailable("drydock does not have " #Name ": " WayRound)))

/** In a struct of many members: it is made, copied, moved and destroyed by functions that are compiled once, where
 * DRYDOCK_DEFINE_COPIES stands, and not in each file that has such a struct. */
#define DRYDOCK_DECLARE_COPIES(Type) \
	DRYDOCK_API Type(); \
	DRYDOCK_API Type(const Type&); \
	DRYDOCK_API Type(Type&&) noexcept; \
	DRYDOCK_API Type& operator=(const Type&); \
	DRYDOCK_API Type& operator=(Type&&) noexcept; \
	DRYDOCK_API ~Type();
#define DRYDOCK_DEFINE_COPIES(Type) \
	Type::Type() = default; \
	Type::Type(const Type&) = default; \
	Type::Type(Type&&) noexcept = default; \
	Type& Type::operator=(const Type&) = default; \
	Type& Type::operator=(Type&&) noexcept = default; \
	Type::~Type() = default;
