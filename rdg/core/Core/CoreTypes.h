// Basic types and compiler macros every header needs: integers, TCHAR, TEXT, inlining, versions and build switches.
// TCHAR is char in UTF-8, so that TEXT("x") is a plain literal. Source: engine CoreTypes.h, HAL/Platform.h, Build.h.
#pragma once

#include "DrydockAPI.h"
#include "Runtime/Launch/Resources/Version.h"

#include <cstddef>
#include <cstdint>
#include <limits>

using int8 = std::int8_t;
using int16 = std::int16_t;
using int32 = std::int32_t;
using int64 = std::int64_t;
using uint8 = std::uint8_t;
using uint16 = std::uint16_t;
using uint32 = std::uint32_t;
using uint64 = std::uint64_t;
using SIZE_T = std::size_t;
using SSIZE_T = std::ptrdiff_t;
using UPTRINT = std::uintptr_t;
using PTRINT = std::intptr_t;

using TCHAR = char;
using ANSICHAR = char;
using UTF8CHAR = char;

#define TEXT(Literal) Literal
#define UTF8TEXT(Literal) Literal
#define TEXTVIEW(Literal) Literal

// Conversions between the engine's string encodings: one encoding here, nothing to convert.
#define TCHAR_TO_ANSI(Text) (Text)
#define TCHAR_TO_UTF8(Text) (Text)
#define ANSI_TO_TCHAR(Text) (Text)
#define UTF8_TO_TCHAR(Text) (Text)

/** "No such index", as returned by the Find functions. */
enum
{
	INDEX_NONE = -1
};

/** Asks a constructor to leave memory alone, to fill it with zeros, or to make it the identity. */
enum ENoInit
{
	NoInit
};
enum EForceInit
{
	ForceInit,
	ForceInitToZero
};

#define MIN_int8 (std::numeric_limits<int8>::lowest())
#define MIN_int16 (std::numeric_limits<int16>::lowest())
#define MIN_int32 (std::numeric_limits<int32>::lowest())
#define MIN_int64 (std::numeric_limits<int64>::lowest())
#define MIN_flt (std::numeric_limits<float>::min())
#define MIN_dbl (std::numeric_limits<double>::min())
#define MAX_int8 (std::numeric_limits<int8>::max())
#define MAX_int16 (std::numeric_limits<int16>::max())
#define MAX_int32 (std::numeric_limits<int32>::max())
#define MAX_int64 (std::numeric_limits<int64>::max())
#define MAX_uint8 (std::numeric_limits<uint8>::max())
#define MAX_uint16 (std::numeric_limits<uint16>::max())
#define MAX_uint32 (std::numeric_limits<uint32>::max())
#define MAX_uint64 (std::numeric_limits<uint64>::max())
#define MAX_flt (std::numeric_limits<float>::max())
#define MAX_dbl (std::numeric_limits<double>::max())

#define FORCEINLINE inline __attribute__((always_inline))
#define FORCEINLINE_DEBUGGABLE inline
#define FORCENOINLINE __attribute__((noinline))
#define RESTRICT __restrict__
#define LIKELY(Expression) __builtin_expect(!!(Expression), 1)
#define UNLIKELY(Expression) __builtin_expect(!!(Expression), 0)
#define UE_NODISCARD [[nodiscard]]
#define UE_NORETURN [[noreturn]]
#define UE_NODEBUG
#define UE_FORCEINLINE_HINT inline
#define UE_ASSUME(Expression)
#define UE_LIFETIMEBOUND
#define CONSTEXPR constexpr
#define TYPENAME_OUTSIDE_TEMPLATE typename
#define STRUCT_OFFSET(Struct, Member) offsetof(Struct, Member)
#define UE_DEPRECATED(Version, Message) [[deprecated(Message)]]
#define PRAGMA_DISABLE_DEPRECATION_WARNINGS \
	_Pragma("GCC diagnostic push") _Pragma("GCC diagnostic ignored \"-Wdeprecated-declarations\"")
#define PRAGMA_ENABLE_DEPRECATION_WARNINGS _Pragma("GCC diagnostic pop")

#define PREPROCESSOR_JOIN_INNER(A, B) A##B
#define PREPROCESSOR_JOIN(A, B) PREPROCESSOR_JOIN_INNER(A, B)
#define UE_JOIN(A, B) PREPROCESSOR_JOIN(A, B)
#define PREPROCESSOR_TO_STRING_INNER(A) #A
#define PREPROCESSOR_TO_STRING(A) PREPROCESSOR_TO_STRING_INNER(A)
#define UE_STRINGIZE(A) PREPROCESSOR_TO_STRING(A)
#define ANONYMOUS_VARIABLE(Name) PREPROCESSOR_JOIN(Name, __LINE__)
#define PURE_VIRTUAL(Function, ...) = 0;

/** A class that is neither copied nor moved. */
#define UE_NONCOPYABLE(TypeName) \
	TypeName(TypeName&&) = delete; \
	TypeName(const TypeName&) = delete; \
	TypeName& operator=(const TypeName&) = delete; \
	TypeName& operator=(TypeName&&) = delete;

namespace Drydock::Private
{

template<typename T, std::size_t Count>
char (&ArrayCountHelper(const T (&)[Count]))[Count];

} // namespace Drydock::Private

/** Number of elements of a C array, a constant; does not compile for a pointer. */
#define UE_ARRAY_COUNT(Array) (sizeof(::Drydock::Private::ArrayCountHelper(Array)))

// The macros that the engine's build tool defines for a non-editor development build on Linux.
#ifndef WITH_EDITOR
#define WITH_EDITOR 0
#endif
#ifndef WITH_EDITORONLY_DATA
#define WITH_EDITORONLY_DATA 0
#endif
#ifndef UE_BUILD_SHIPPING
#define UE_BUILD_SHIPPING 0
#endif
#ifndef UE_BUILD_TEST
#define UE_BUILD_TEST 0
#endif
#ifndef UE_BUILD_DEBUG
#ifdef NDEBUG
#define UE_BUILD_DEBUG 0
#else
#define UE_BUILD_DEBUG 1
#endif
#endif
#ifndef UE_BUILD_DEVELOPMENT
#define UE_BUILD_DEVELOPMENT (!UE_BUILD_DEBUG)
#endif
#define UE_SERVER 0
#define UE_GAME 1
#define UE_EDITOR 0
#define PLATFORM_WINDOWS 0
#define PLATFORM_MAC 0
#define PLATFORM_IOS 0
#define PLATFORM_ANDROID 0
#define PLATFORM_LINUX 1
#define PLATFORM_UNIX 1
#define PLATFORM_DESKTOP 1
#define PLATFORM_64BITS 1
#define PLATFORM_LITTLE_ENDIAN 1
#define PLATFORM_CACHE_LINE_SIZE 64
#define DO_CHECK 1
#define DO_ENSURE 1
#define DO_GUARD_SLOW UE_BUILD_DEBUG

// Export macros of the engine's modules: class declarations copied from engine code may carry them.
#define CORE_API
#define COREUOBJECT_API
#define ENGINE_API
#define RENDERCORE_API
#define RENDERER_API
#define RHI_API
