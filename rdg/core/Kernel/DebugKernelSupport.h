// Declares what shaders compiled for a debugger share, besides their own functions: the place of the run's words, and
// the functions that a person may call from the debugger. Included by generated code only.
#pragma once

#include "DebugKernel.h"

#include <cstdio>

using uint = uint32_t;
using float16_t = float; // whose values are those of 16 bits

/** An array as a local variable: a debugger shows "float4 [5]". */
template<typename T, uint Count>
using DrydockArray = T[Count];

/** An array or matrix that a function returns. */
template<typename T>
struct DrydockValue
{
	T Value;
};

/** The pixel, or the dispatch id, that runs. */
struct DrydockPixelPosition
{
	int x, y, z;
};
static DrydockPixelPosition DrydockPixel;

static Drydock::FDebugKernelArgs* DrydockRun;
static uint64_t* DrydockWords;

// Calls that a debugger steps over. The variable's numbers have 32 bits.
#define DrydockTake(Words, To, Count) DrydockRun->Take(Words, To, Count)
#define DrydockPut(Words, From, Count) DrydockRun->Put(Words, From, Count)
#define DrydockDo(Step) DrydockRun->Execute(DrydockRun->Self, Step)
#define DrydockTurn(To, From) DrydockRun->Turn(DrydockRun->Self, To, From)

/** From the debugger: the shader runs once more, for another pixel or thread, when it is through with this one. */
[[gnu::used]] const char* DrydockDebugPixel(int X, int Y, int Z)
{
	const int At[3] = {X, Y, Z};
	for (int Axis = 0; Axis < 3; ++Axis)
	{
		if (!DrydockRun || At[Axis] < DrydockRun->Min[Axis] || At[Axis] >= DrydockRun->Max[Axis])
		{
			return "outside of what this pass draws";
		}
	}
	for (int Axis = 0; Axis < 3; ++Axis)
	{
		DrydockRun->Next[Axis] = At[Axis];
	}
	DrydockRun->bAgain = true;
	return "this pixel is next: continue";
}

[[gnu::used]] const char* DrydockDebugPixel(int X, int Y)
{
	return DrydockDebugPixel(X, Y, DrydockPixel.z);
}

/** At the end of a run: a DrydockPixel that the debugger's user has set is the next one. */
struct DrydockSetPixel
{
	~DrydockSetPixel()
	{
		const int* const Ran = DrydockRun->Position;
		if (DrydockPixel.x != Ran[0] || DrydockPixel.y != Ran[1] || DrydockPixel.z != Ran[2])
		{
			std::fprintf(
				stderr, "DrydockPixel: %s\n", DrydockDebugPixel(DrydockPixel.x, DrydockPixel.y, DrydockPixel.z));
		}
	}
};
