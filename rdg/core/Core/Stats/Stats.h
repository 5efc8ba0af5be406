// Statistics macros, which measure nothing: the graph measures its passes itself. Source: engine Stats/Stats.h,
// ProfilingDebugging/CsvProfiler.h, ProfilingDebugging/RealtimeGPUProfiler.h (the GPU ones are in RHI).
#pragma once

/** Names a statistic; here nothing. */
struct TStatId
{
};
#define RETURN_QUICK_DECLARE_CYCLE_STAT(Stat, Group) return TStatId();

#define SCOPE_CYCLE_COUNTER(Stat)
#define QUICK_SCOPE_CYCLE_COUNTER(Stat)
#define DECLARE_CYCLE_STAT(Description, Stat, Group)
#define DECLARE_CYCLE_STAT_EXTERN(Description, Stat, Group, Api)
#define DECLARE_STATS_GROUP(Description, Group, Category)
#define DEFINE_STAT(Stat)
#define DECLARE_DWORD_COUNTER_STAT(Description, Stat, Group)
#define DECLARE_MEMORY_STAT(Description, Stat, Group)
#define INC_DWORD_STAT(Stat)
#define DEC_DWORD_STAT(Stat)
#define SET_DWORD_STAT(Stat, Value)
#define INC_MEMORY_STAT_BY(Stat, Value)
#define DEC_MEMORY_STAT_BY(Stat, Value)
#define TRACE_CPUPROFILER_EVENT_SCOPE(Name)
#define TRACE_CPUPROFILER_EVENT_SCOPE_STR(Name)
#define SCOPED_NAMED_EVENT(Name, Color)
#define SCOPED_NAMED_EVENT_TEXT(Name, Color)
#define CSV_SCOPED_TIMING_STAT(Category, Stat)
#define CSV_SCOPED_TIMING_STAT_EXCLUSIVE(Stat)
#define CSV_DEFINE_CATEGORY(Category, bEnabled)
#define LLM_SCOPE(Tag)
#define LLM_SCOPE_BYTAG(Tag)
