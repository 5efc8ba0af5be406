// Names of passes and scopes. Names are formatted at once; scopes nest and become the path that a pass is listed under.
// Source: engine RenderGraphEvent.h.
#pragma once

#include "CoreMinimal.h"

/** A printf-formatted name. */
class DRYDOCK_API FRDGEventName
{
public:
	FRDGEventName() = default;
	explicit FRDGEventName(const TCHAR* Format, ...) __attribute__((format(printf, 2, 3)));

	const TCHAR* GetTCHAR() const { return *Name; }
	bool HasFormat() const { return true; }

private:
	FString Name;
};

#define RDG_EVENT_JOIN_INNER(A, B) A##B
#define RDG_EVENT_JOIN(A, B) RDG_EVENT_JOIN_INNER(A, B)

/** `RDG_EVENT_NAME("Blur %dx%d", X, Y)`. */
#define RDG_EVENT_NAME(Format, ...) FRDGEventName(TEXT(Format) __VA_OPT__(, ) __VA_ARGS__)

// Scopes end with the block; the macros bring their own semicolon, as the engine's do. FRDGEventScopeGuard comes with
// the builder (RenderGraphBuilder.h).
#define RDG_EVENT_SCOPE(GraphBuilder, Format, ...) \
	FRDGEventScopeGuard RDG_EVENT_JOIN(RDGEventScope, __LINE__)( \
		GraphBuilder, RDG_EVENT_NAME(Format __VA_OPT__(, ) __VA_ARGS__));
#define RDG_EVENT_SCOPE_CONDITIONAL(GraphBuilder, Condition, Format, ...) \
	FRDGEventScopeGuard RDG_EVENT_JOIN(RDGEventScope, __LINE__)( \
		GraphBuilder, RDG_EVENT_NAME(Format __VA_OPT__(, ) __VA_ARGS__), !!(Condition));
/** Scopes inside it are not recorded. */
#define RDG_EVENT_SCOPE_FINAL(GraphBuilder, Format, ...) \
	FRDGEventScopeGuard RDG_EVENT_JOIN(RDGEventScope, __LINE__)( \
		GraphBuilder, RDG_EVENT_NAME(Format __VA_OPT__(, ) __VA_ARGS__), true, true);
#define RDG_EVENT_SCOPE_STAT(GraphBuilder, StatName, Format, ...) \
	RDG_EVENT_SCOPE(GraphBuilder, Format __VA_OPT__(, ) __VA_ARGS__)

// Stats: times are kept per pass and per scope anyway, so a stat only has to exist.
#define DECLARE_GPU_STAT(StatName) [[maybe_unused]] static constexpr const TCHAR* GPUStat_##StatName = TEXT(#StatName);
#define DECLARE_GPU_STAT_NAMED(StatName, NameString) \
	[[maybe_unused]] static constexpr const TCHAR* GPUStat_##StatName = NameString;
#define DECLARE_GPU_STAT_NAMED_EXTERN(StatName, NameString) DECLARE_GPU_STAT_NAMED(StatName, NameString)
#define DECLARE_GPU_DRAWCALL_STAT(StatName) DECLARE_GPU_STAT(StatName)
#define DECLARE_GPU_DRAWCALL_STAT_NAMED(StatName, NameString) DECLARE_GPU_STAT_NAMED(StatName, NameString)
#define DECLARE_GPU_DRAWCALL_STAT_EXTERN(StatName) DECLARE_GPU_STAT(StatName)
#define DEFINE_GPU_STAT(StatName)
#define DEFINE_GPU_DRAWCALL_STAT(StatName)
/** A stat that is declared nowhere passes, as where the engine is built without GPU stats. */
#define RDG_GPU_STAT_SCOPE(GraphBuilder, StatName) static_cast<void>(GraphBuilder);
#define RDG_GPU_STAT_SCOPE_VERBOSE(GraphBuilder, StatName, Description) RDG_GPU_STAT_SCOPE(GraphBuilder, StatName)
#define SCOPED_GPU_STAT(RHICmdList, StatName) static_cast<void>(RHICmdList);
#define RDG_CSV_STAT_EXCLUSIVE_SCOPE(GraphBuilder, StatName) static_cast<void>(GraphBuilder);
#define RDG_GPU_MASK_SCOPE(GraphBuilder, GPUMask) static_cast<void>(GraphBuilder);
#define RDG_RHI_EVENT_SCOPE(GraphBuilder, Name) RDG_EVENT_SCOPE(GraphBuilder, #Name)
#define SCOPED_DRAW_EVENT(RHICmdList, Name) static_cast<void>(RHICmdList);
#define SCOPED_DRAW_EVENTF(RHICmdList, Name, Format, ...) static_cast<void>(RHICmdList);
