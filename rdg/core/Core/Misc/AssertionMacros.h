// check, verify and ensure. A failed check throws Drydock::FCheckFailure instead of stopping the program, so that tests
// and the command line can report it; a failed ensure prints once per site and yields false. Both print their message
// on stderr, as the engine's log does. All are active in every build; checkSlow only in debug builds. Source: engine
// Misc/AssertionMacros.h.
#pragma once

#include "CoreTypes.h"

#include <atomic>
#include <functional>
#include <stdexcept>
#include <string>

namespace Drydock
{

/** A failed check: a fault of the calling code, its message already printed on stderr (except in a plugin's code, whose
 * failed check is reported by its caller). */
class DRYDOCK_API FCheckFailure : public std::runtime_error
{
public:
	explicit FCheckFailure(const std::string& Message, bool bInOfPlugin = false);
	~FCheckFailure() override;

	/** The check stands in a plugin's own code. */
	bool IsOfPlugin() const { return bOfPlugin; }

private:
	bool bOfPlugin;
};

/** Prints "Assertion failed: Expression [File:x] [Line: n] message" on stderr and throws it. Format may be null. */
[[noreturn]] DRYDOCK_API void FailCheck(const char* Expression, const char* File, int Line,
	const char* Format = nullptr, ...) __attribute__((format(printf, 4, 5)));

/** Reports a failed ensure: prints unless bReported, which it sets. Always counts; always returns false. */
DRYDOCK_API bool FailEnsure(std::atomic<bool>& bReported, bool bAlways, const char* Expression, const char* File,
	int Line, const char* Format = nullptr, ...) __attribute__((format(printf, 6, 7)));

/** Number of failed ensures of this process so far, also those that were not printed again. */
DRYDOCK_API uint64 GetEnsureCount();

/** A handler receives every failed ensure in place of stderr; null restores printing. Returns the handler before. */
using FEnsureHandler = std::function<void(const std::string& Message)>;
DRYDOCK_API FEnsureHandler SetEnsureHandler(FEnsureHandler Handler);

} // namespace Drydock

#define check(Expression) \
	do \
	{ \
		if (UNLIKELY(!(Expression))) \
		{ \
			::Drydock::FailCheck(#Expression, __FILE__, __LINE__); \
		} \
	} while (0)

/** check with a printf-style message. */
#define checkf(Expression, Format, ...) \
	do \
	{ \
		if (UNLIKELY(!(Expression))) \
		{ \
			::Drydock::FailCheck(#Expression, __FILE__, __LINE__, Format __VA_OPT__(, ) __VA_ARGS__); \
		} \
	} while (0)

// verify evaluates its expression in every build; so does check here.
#define verify(Expression) check(Expression)
#define verifyf(Expression, Format, ...) checkf(Expression, Format __VA_OPT__(, ) __VA_ARGS__)

#define checkCode(Code) \
	do \
	{ \
		Code; \
	} while (0)
#define checkNoEntry() ::Drydock::FailCheck("Enclosing block should never be called", __FILE__, __LINE__)
#define unimplemented() ::Drydock::FailCheck("Unimplemented function called", __FILE__, __LINE__)

#if DO_GUARD_SLOW
#define checkSlow(Expression) check(Expression)
#define checkfSlow(Expression, Format, ...) checkf(Expression, Format __VA_OPT__(, ) __VA_ARGS__)
#define verifySlow(Expression) check(Expression)
#else
#define checkSlow(Expression) static_cast<void>(sizeof(!(Expression)))
#define checkfSlow(Expression, Format, ...) static_cast<void>(sizeof(!(Expression)))
#define verifySlow(Expression) static_cast<void>(Expression)
#endif

#define DRYDOCK_ENSURE(Capture, bAlways, Expression, ...) \
	(LIKELY(!!(Expression)) || ([Capture]() -> bool { \
		static std::atomic<bool> bReported{false}; \
		return ::Drydock::FailEnsure(bReported, bAlways, #Expression, __FILE__, __LINE__ __VA_OPT__(, ) __VA_ARGS__); \
	}()))

/** Yields the expression as bool; if false, prints "Ensure condition failed: ..." the first time at this site. */
#define ensure(Expression) DRYDOCK_ENSURE(, false, Expression)
#define ensureMsgf(Expression, Format, ...) DRYDOCK_ENSURE(&, false, Expression, Format __VA_OPT__(, ) __VA_ARGS__)
#define ensureAlways(Expression) DRYDOCK_ENSURE(, true, Expression)
#define ensureAlwaysMsgf(Expression, Format, ...) DRYDOCK_ENSURE(&, true, Expression, Format __VA_OPT__(, ) __VA_ARGS__)
