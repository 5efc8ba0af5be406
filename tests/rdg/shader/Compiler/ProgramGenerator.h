// Random HLSL: functions full of divergent control flow, whose results a kernel and the model must agree on.
// Every program ends and never divides by an unknown zero in integers.
#pragma once

#include <random>
#include <initializer_list>
#include <string>
#include <utility>
#include <vector>

namespace Drydock::Test
{

/** A compute shader `MainCS` with NumFunctions random functions. Inputs: Data (StructuredBuffer<float4>), UniformInt,
 *  UniformFloat, Table (float4[8] constants); outputs per thread and function: OutFloat (float4), OutInt (int4), Log.
 */
class FProgramGenerator
{
public:
	explicit FProgramGenerator(uint32_t Seed)
		: Random(Seed)
	{
	}

	std::string Make(int NumFunctions);

private:
	std::string Function(int Index);
	std::string Statements(int Depth, int Count);
	std::string Statement(int Depth);
	std::string Loop(int Depth);
	std::string Switch(int Depth);
	std::string Float(int Depth);
	std::string Int(int Depth);
	std::string Uint(int Depth);
	std::string Bool(int Depth);
	std::string Vector(int Depth);
	std::string Pick(std::initializer_list<const char*> List) { return *(List.begin() + Below(int(List.size()))); }
	int Below(int Limit) { return int(Random() % uint32_t(Limit)); }
	bool Chance(int Percent) { return Below(100) < Percent; }
	std::string Indent() const { return std::string(size_t(IndentLevel), '\t'); }

	std::mt19937 Random;
	int IndentLevel = 0;
	int NumNames = 0;
	std::vector<std::string> LoopNames;
	int LoopDepth = 0;
	int SwitchDepth = 0;
	int NumFunctions = 0; // written so far
	bool bInHelper = false;
};

} // namespace Drydock::Test
