// A loop of a shader that goes on after r.Drydock.ShaderLoopLimit turns is a message with line and thread, wherever it
// runs: compiled for any number of lanes, interpreted, looked into.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "Diagnostics.h"
#include "HAL/IConsoleManager.h"
#include "ShaderHarness.h"

namespace
{

using namespace Drydock;
using namespace Drydock::Test;

constexpr int32 Limit = 1000;

class FLoopLimit : public testing::Test
{
protected:
	FLoopLimit() { Set(Limit); }
	~FLoopLimit() override { Set(1 << 22); }

	static void Set(int32 Turns)
	{
		IConsoleManager::Get().FindConsoleVariable(TEXT("r.Drydock.ShaderLoopLimit"))->Set(Turns, ECVF_SetByCode);
	}

	/** What Run throws, as the user reads it; empty: nothing. */
	template<typename TRun>
	static std::string Catch(TRun Run)
	{
		try
		{
			Run();
		}
		catch (const FError& Error)
		{
			EXPECT_EQ(ExitUsage, Error.GetExitCode());
			return Error.GetDiagnostics().at(0).ToString();
		}
		return {};
	}

	/** The message of each way to run the shader over 16 x 4 threads must be Expected. */
	static void Check(const std::string& Text, EShaderStage Stage, const std::string& Expected, bool bConstant = false)
	{
		FShaderHarness Harness(Text, "Main", Stage);
		Harness.Buffers["Turns"] = {1, 0, 3000, 1000};
		Harness.Buffers["Out"] = std::vector<uint32_t>(64);
		Harness.Targets = {FTestTexture(16, 4)};
		for (const int32_t Lanes : GetLaneCounts())
		{
			EXPECT_EQ(Expected, Catch([&] { Harness.Run(Lanes, 16, 4); })) << Lanes << " lanes\n" << Text;
		}
		EXPECT_EQ(Expected, Catch([&] { Harness.RunModel(16, 4); })) << "interpreted\n" << Text;
		if (!bConstant) // whose turns the text with its variables does not say
		{
			EXPECT_EQ(Expected, Catch([&] { Harness.RunInspected(16, 4); })) << "looked into\n" << Text;
		}
	}

	static std::string Message(int Line, const char* Thread)
	{
		return "/Test/Shader.usf:" + std::to_string(Line) +
			   ": error: this loop goes on after 1000 turns in the pixel or thread (" + Thread +
			   ") of a shader: does it have an end? (r.Drydock.ShaderLoopLimit) [DD6041]";
	}
};

const std::string Compute = "StructuredBuffer<uint> Turns;\nRWStructuredBuffer<uint> Out;\n";

} // namespace

TEST_F(FLoopLimit, ALoopThatOneThreadDoesNotLeave)
{
	Check(Compute + R"([numthreads(16, 4, 1)]
void Main(uint3 Id : SV_DispatchThreadID)
{
	uint Sum = 0;
	while (Id.x != 5 || Sum < 2 || Id.y < 2)
	{
		++Sum;
		if (Sum > 40 && (Id.x != 9 || Id.y != 1))
			break;
	}
	Out[Id.y * 16 + Id.x] = Sum;
}
)",
		EShaderStage::Compute, Message(7, "9, 1"));
}

TEST_F(FLoopLimit, AsManyTurnsAsAllowedAreNoFault)
{
	const std::string Text = Compute + R"([numthreads(16, 4, 1)]
void Main(uint3 Id : SV_DispatchThreadID)
{
	for (uint i = 0; i < Turns[AT]; ++i)
		Out[Id.y * 16 + Id.x] += i;
}
)";
	Check("#define AT 3\n" + Text, EShaderStage::Compute, "");
	Check("#define AT 2\n" + Text, EShaderStage::Compute, Message(7, "0, 0"));
}

TEST_F(FLoopLimit, LoopsByConstantsDoNotCountUnlessTheyNeverEnd)
{
	Check(Compute + "[numthreads(16, 4, 1)] void Main(uint3 Id : SV_DispatchThreadID)\n{\n"
					"	[loop] for (int i = 0; i < 2000; ++i) Out[Id.y * 16 + Id.x] += Turns[i & 3];\n}\n",
		EShaderStage::Compute, "", true);
	Check(Compute + "[numthreads(16, 4, 1)] void Main(uint3 Id : SV_DispatchThreadID)\n{\n"
					"	[loop] for (uint i = 3; i >= 0; --i) Out[Id.y * 16 + Id.x] += Turns[i & 3];\n}\n",
		EShaderStage::Compute, Message(5, "0, 0"));
}

TEST_F(FLoopLimit, ALoopInsideOfOneThatEnds)
{
	Check("StructuredBuffer<uint> Turns;\n"
		  "float4 Main(float4 P : SV_POSITION) : SV_Target0\n{\n	float Sum = 0;\n"
		  "	for (uint i = 0; i < Turns[0]; ++i)\n	{\n"
		  "		float x = P.x;\n"
		  "		while (x < 12)\n			x += P.y > 2 && P.x > 4 ? 0 : 1;\n"
		  "		Sum += x;\n	}\n	return Sum;\n}\n",
		EShaderStage::Pixel, Message(8, "4, 2"));
}

TEST_F(FLoopLimit, LoopsAroundBarriersAndInGroups)
{
	const std::string Head = Compute + "groupshared uint Shared[64];\n[numthreads(16, 2, 1)]\n"
									   "void Main(uint3 Id : SV_DispatchThreadID, uint Index : SV_GroupIndex)\n{\n"
									   "	Shared[Index] = Index;\n	GroupMemoryBarrierWithGroupSync();\n";
	Check(Head + "	uint i = 0;\n	while (i < Turns[2])\n	{\n		Shared[Index ^ 1] = i++;\n"
				 "		GroupMemoryBarrierWithGroupSync();\n	}\n	Out[Id.y * 16 + Id.x] = Shared[Index];\n}\n",
		EShaderStage::Compute, Message(10, "0, 0"));
	Check(Head + "	uint i = Shared[Index ^ 1];\n	while (i != 17)\n		i = i == 3 ? 3 : 17;\n"
				 "	Out[Id.y * 16 + Id.x] = i;\n}\n",
		EShaderStage::Compute, Message(10, "2, 0"));
}

// The optimiser knows that they have no effect, or no end.
TEST_F(FLoopLimit, LoopsWithoutEndWhoseEndTheTextRulesOut)
{
	struct FCase
	{
		const char* Text;
		int Line;
		const char* Thread;
	};
	for (const FCase& Case :
		{FCase{"	while (true) {}\n", 5, "0, 0"}, FCase{"	for (uint i = 3; i >= 0; --i) {}\n", 5, "0, 0"},
			FCase{"	float x = 0;\n	do { x += 1; } while (true);\n", 6, "0, 0"},
			FCase{"	uint n = 1;\n	while (n != 0) { n |= 1; }\n", 6, "0, 0"},
			FCase{"	uint n = Id.y;\n	while (n < 2) { n = n & 1; }\n", 6, "0, 0"},
			FCase{"	if (Id.x == 5 && Id.y > 1)\n		for (;;) {}\n", 6, "5, 2"},
			FCase{"	Spin(Id.x == 7);\n", 1, "7, 0"}, FCase{"	Spin(false);\n", 1, ""}})
	{
		const std::string Expected = *Case.Thread ? Message(Case.Line, Case.Thread) : std::string();
		const std::string Head = "void Spin(bool b) { while (b) {} }\n";
		Check(
			Head +
				"RWStructuredBuffer<uint> Out;\n[numthreads(16, 1, 1)]\nvoid Main(uint3 Id : SV_DispatchThreadID) {\n" +
				Case.Text + "	Out[Id.y * 16 + Id.x] = 1;\n}\n",
			EShaderStage::Compute, Expected);
		Check(Head + "\nfloat4 Main(float4 P : SV_POSITION) : SV_Target0\n{	uint2 Id = uint2(P.xy);\n" + Case.Text +
				  "	return P.x;\n}\n",
			EShaderStage::Pixel, Expected);
	}
}

TEST_F(FLoopLimit, ZeroIsNoLimit)
{
	Set(0);
	Check(Compute + "[numthreads(16, 4, 1)] void Main(uint3 Id : SV_DispatchThreadID)\n{\n"
					"	for (uint i = 0; i < Turns[2]; ++i) Out[Id.y * 16 + Id.x] += i;\n}\n",
		EShaderStage::Compute, "");
}
