// Bit operators for scoped enums. Source: engine Misc/EnumClassFlags.h.
#pragma once

#include "CoreTypes.h"

#include <type_traits>

/** Gives Enum the operators |, &, ^, ~, ! and their assigning forms; they are found beside the enum. */
#define ENUM_CLASS_FLAGS(Enum) \
	inline constexpr Enum operator|(Enum A, Enum B) \
	{ \
		return static_cast<Enum>( \
			static_cast<std::underlying_type_t<Enum>>(A) | static_cast<std::underlying_type_t<Enum>>(B)); \
	} \
	inline constexpr Enum operator&(Enum A, Enum B) \
	{ \
		return static_cast<Enum>( \
			static_cast<std::underlying_type_t<Enum>>(A) & static_cast<std::underlying_type_t<Enum>>(B)); \
	} \
	inline constexpr Enum operator^(Enum A, Enum B) \
	{ \
		return static_cast<Enum>( \
			static_cast<std::underlying_type_t<Enum>>(A) ^ static_cast<std::underlying_type_t<Enum>>(B)); \
	} \
	inline constexpr Enum operator~(Enum A) \
	{ \
		return static_cast<Enum>(~static_cast<std::underlying_type_t<Enum>>(A)); \
	} \
	inline constexpr bool operator!(Enum A) \
	{ \
		return !static_cast<std::underlying_type_t<Enum>>(A); \
	} \
	inline constexpr Enum& operator|=(Enum& A, Enum B) \
	{ \
		return A = A | B; \
	} \
	inline constexpr Enum& operator&=(Enum& A, Enum B) \
	{ \
		return A = A & B; \
	} \
	inline constexpr Enum& operator^=(Enum& A, Enum B) \
	{ \
		return A = A ^ B; \
	}

/** The same for an enum declared inside a class, as friends of that class. */
#define FRIEND_ENUM_CLASS_FLAGS(Enum) \
	friend constexpr Enum operator|(Enum A, Enum B); \
	friend constexpr Enum operator&(Enum A, Enum B); \
	friend constexpr Enum operator^(Enum A, Enum B); \
	friend constexpr Enum operator~(Enum A); \
	friend constexpr bool operator!(Enum A); \
	friend constexpr Enum& operator|=(Enum& A, Enum B); \
	friend constexpr Enum& operator&=(Enum& A, Enum B); \
	friend constexpr Enum& operator^=(Enum& A, Enum B);

/** True if all bits of Contains are set in Flags. */
template<typename Enum>
constexpr bool EnumHasAllFlags(Enum Flags, Enum Contains)
{
	using FUnderlying = std::underlying_type_t<Enum>;
	return (static_cast<FUnderlying>(Flags) & static_cast<FUnderlying>(Contains)) == static_cast<FUnderlying>(Contains);
}

/** True if at least one bit of Contains is set in Flags. */
template<typename Enum>
constexpr bool EnumHasAnyFlags(Enum Flags, Enum Contains)
{
	using FUnderlying = std::underlying_type_t<Enum>;
	return (static_cast<FUnderlying>(Flags) & static_cast<FUnderlying>(Contains)) != 0;
}

/** True if Flags has no bits outside Contains. */
template<typename Enum>
constexpr bool EnumOnlyContainsFlags(Enum Flags, Enum Contains)
{
	using FUnderlying = std::underlying_type_t<Enum>;
	return (static_cast<FUnderlying>(Flags) & ~static_cast<FUnderlying>(Contains)) == 0;
}

template<typename Enum>
constexpr void EnumAddFlags(Enum& Flags, Enum Added)
{
	using FUnderlying = std::underlying_type_t<Enum>;
	Flags = static_cast<Enum>(static_cast<FUnderlying>(Flags) | static_cast<FUnderlying>(Added));
}

template<typename Enum>
constexpr void EnumRemoveFlags(Enum& Flags, Enum Removed)
{
	using FUnderlying = std::underlying_type_t<Enum>;
	Flags = static_cast<Enum>(static_cast<FUnderlying>(Flags) & ~static_cast<FUnderlying>(Removed));
}
