// Holds the steps of one shader thread, line by line: data that text and JSON are made from.
#pragma once

#include "Footprint.h"
#include "SpirvModule.h"

#include <array>
#include <string>

namespace Drydock
{

/** A value as its words lie in a row: of a type of the module. */
struct FTraceValue
{
	uint32_t Type = 0;
	std::vector<double> Reals;  // each word as a number
	std::vector<uint32_t> Bits; // each word as bits, of integers and bools
};

enum class ETraceEvent : uint8_t
{
	Value,  // Name = Value
	Sample, // Name at Coordinates on Level = Value
	Load,   // Name[Texel] = Value
	Store,  // Name[Texel] takes Value
	Branch, // Value is the condition, or what a switch chose by
	Call,   // of function Name
	Return, // from function Name, with Value
	Fault   // Name: what went wrong
};

struct FTraceEvent
{
	ETraceEvent Kind = ETraceEvent::Value;
	std::string Name;
	FTraceValue Value;
	std::vector<double> Coordinates;     // Sample
	double Level = 0;                    // Sample
	std::vector<int64_t> Texel;          // Load, Store: x, y, z, mip
	std::vector<FFootprintTexel> Texels; // Sample
	std::array<int32_t, 3> Writer = {};  // Load of groupshared memory: the thread that had put it there
	int WriterLine = 0;                  // and its line; 0: another load, or nothing wrote the memory
	bool bShared = false;                // it is one
};

/** A stay on one line: a line in a loop comes once for every time. */
struct FTraceLine
{
	std::string File; // virtual
	int Line = 0;
	std::string Function;
	size_t Depth = 0; // calls that have not returned
	std::vector<FTraceEvent> Events;
};

struct FPixelTrace
{
	std::vector<FTraceLine> Lines;
	bool bCut = false; // there were more than MaxTraceLines or MaxTraceEvents
	bool bDiscarded = false;
	std::vector<std::vector<double>> Targets; // by SV_Target: what was written, before the format rounds it
	uint64_t Taps = 0;
	uint64_t Steps = 0;
};

constexpr size_t MaxTraceLines = 200000;
constexpr size_t MaxTraceEvents = 500000; // of all lines

} // namespace Drydock
