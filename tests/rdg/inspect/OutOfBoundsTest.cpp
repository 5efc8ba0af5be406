// What lies outside: reads of buffers and textures give 0 and writes are dropped, as in Direct3D; of arrays the last
// element is taken, which Direct3D leaves undefined. Compiled for any number of lanes, interpreted and looked into it
// is the same, and the check names line and thread.
#include <gtest/gtest.h>

#include "InspectTestUtils.h"
#include "KernelCheck.h"

namespace
{

using namespace Drydock;
using namespace Drydock::Test;

constexpr int32_t NumThreads = 8;
constexpr int32_t NumElements = 5; // of everything that is accessed
using FWords = std::vector<uint32_t>;

struct FAccess
{
	const char* Name;
	std::string Body;    // of the thread x; writes Out[x] or what is accessed
	FWords Out;          // 8 words
	FWords Small;        // what the accessed buffer holds afterwards; empty: 1 to 5
	std::string Finding; // of the check; X: the thread
};

FShaderHarness MakeHarness(const FAccess& Access)
{
	FShaderHarness Harness(
		"StructuredBuffer<uint> In; ByteAddressBuffer Bytes; Buffer<uint> Typed; Texture2D<uint> Image;\n"
		"RWStructuredBuffer<uint> Out; RWStructuredBuffer<uint> Small; RWByteAddressBuffer SmallBytes;\n"
		"RWBuffer<uint> SmallTyped; RWTexture2D<uint> SmallImage; uint4 Table[5];"
		"AppendStructuredBuffer<uint> SmallAppended; ConsumeStructuredBuffer<uint> Consumed;\n"
		"groupshared uint Shared[5];\n"
		"[numthreads(8, 1, 1)] void Main(uint3 Id : SV_DispatchThreadID, uint x : SV_GroupIndex)\n{\n" +
			Access.Body + "\n}\n",
		"Main", EShaderStage::Compute);
	for (const char* const Name :
		{"In", "Bytes", "Typed", "Small", "SmallBytes", "SmallTyped", "SmallAppended", "Consumed"})
	{
		Harness.Buffers[Name] = {1, 2, 3, 4, 5};
	}
	Harness.Buffers["SmallAppended@count"] = {0};
	Harness.Buffers["Consumed@count"] = {5};
	Harness.Buffers["Out"] = FWords(NumThreads, 9);
	for (const char* const Name : {"Image", "SmallImage"})
	{
		Harness.Textures[Name] = FTestTexture(NumElements, 1, true);
		for (int32_t X = 0; X < NumElements; ++X)
		{
			Harness.Textures[Name].Uint(X, 0) = uint32_t(X + 1);
		}
	}
	for (uint32_t i = 0; i < uint32_t(NumElements); ++i)
	{
		Harness.Constants["Table"].insert(Harness.Constants["Table"].end(), {i + 1, 0, 0, 0});
	}
	return Harness;
}

std::vector<FAccess> GetAccesses()
{
	const FWords Zero = {1, 2, 3, 4, 5, 0, 0, 0};
	const FWords Last = {1, 2, 3, 4, 5, 5, 5, 5};
	const FWords Unwritten(NumThreads, 9);
	const FWords Written = {10, 10, 10, 10, 10};
	const auto Read = [](const std::string& Of, const std::string& At, const std::string& Bounds)
	{
		return "a read of " + Of + At + ", which " + Bounds + "; it gives 0";
	};
	const auto Store = [](const std::string& Of, const std::string& At, const std::string& Bounds)
	{
		return "a store to " + Of + At + ", which " + Bounds + "; it is dropped";
	};
	const std::string Five = "has 5 elements";
	const std::string Element = "element 5 of an array that has 5; the nearest is taken";
	return {
		{"StructuredBuffer", "Out[x] = In[x];", Zero, {}, Read("In", "[5]", Five)},
		{"ByteAddressBuffer", "Out[x] = Bytes.Load(x * 4);", Zero, {}, Read("Bytes", "[5]", Five)},
		{"Buffer", "Out[x] = Typed[x];", Zero, {}, Read("Typed", "[5]", Five)},
		{"Texture2D", "Out[x] = Image.Load(int3(x, 0, 0));", Zero, {}, Read("Image", " at (5, 0)", "is 5 x 1")},
		{"RWStructuredBuffer, read", "Out[x] = Small[x];", Zero, {}, Read("Small", "[5]", Five)},
		{"RWStructuredBuffer", "Small[x] = 10;", Unwritten, Written, Store("Small", "[5]", Five)},
		{"RWByteAddressBuffer", "SmallBytes.Store(x * 4, 10);", Unwritten, Written, Store("SmallBytes", "[5]", Five)},
		{"RWBuffer", "SmallTyped[x] = 10;", Unwritten, Written, Store("SmallTyped", "[5]", Five)},
		{"AppendStructuredBuffer", "SmallAppended.Append(10);", Unwritten, Written,
			Store("SmallAppended", "[5]", Five)},
		{"ConsumeStructuredBuffer", "Out[x] = Consumed.Consume();", {5, 4, 3, 2, 1, 0, 0, 0}, {},
			Read("Consumed", "[4294967295]", Five)},
		{"RWTexture2D", "SmallImage[uint2(x, 0)] = 10;", Unwritten, Written,
			Store("SmallImage", " at (5, 0)", "is 5 x 1")},
		{"local array, read", "uint A[5] = {1, 2, 3, 4, 5}; A[x & 1] = (x & 1) + 1; Out[x] = A[x];", Last, {}, Element},
		{"local array, written", "uint A[5] = {1, 2, 3, 4, 5}; A[x] = 10; Out[x] = A[4];", {5, 5, 5, 5, 10, 10, 10, 10},
			{}, Element},
		{"array of constants", "Out[x] = Table[x].x;", Last, {}, Element},
		{"groupshared, read", "if (x < 5) Shared[x] = x + 1; GroupMemoryBarrierWithGroupSync(); Out[x] = Shared[x];",
			Last, {}, Element},
		{"groupshared, written",
			"if (x < 5) Shared[x] = 1; GroupMemoryBarrierWithGroupSync(); if (x > 3) Shared[x] = 7;\n"
			"GroupMemoryBarrierWithGroupSync(); Out[x] = Shared[min(x, 4u)];",
			{1, 1, 1, 1, 7, 7, 7, 7}, {}, Element},
	};
}

/** Whatever the accessed buffers and textures hold. */
void Compare(const FAccess& Access, FShaderHarness& Harness, const std::string& How)
{
	EXPECT_EQ(Access.Out, Harness.Buffers["Out"]) << Access.Name << ", " << How;
	const FWords Small = Access.Small.empty() ? FWords{1, 2, 3, 4, 5} : Access.Small;
	const FWords Untouched = {1, 2, 3, 4, 5};
	for (const char* const Name : {"Small", "SmallBytes", "SmallTyped", "SmallAppended"})
	{
		const bool bAccessed =
			Access.Body.starts_with(std::string(Name) + "[") || Access.Body.starts_with(std::string(Name) + ".");
		EXPECT_EQ(bAccessed ? Small : Untouched, Harness.Buffers[Name]) << Access.Name << ", " << How;
	}
	for (int32_t X = 0; X < NumElements; ++X)
	{
		const bool bAccessed = Access.Body.starts_with("SmallImage[");
		EXPECT_EQ((bAccessed ? Small : Untouched)[size_t(X)], Harness.Textures["SmallImage"].Uint(X, 0))
			<< Access.Name << ", " << How;
	}
}

} // namespace

TEST(OutOfBounds, IsAsInDirect3DHoweverItRuns)
{
	for (const FAccess& Access : GetAccesses())
	{
		for (const int32_t Lanes : GetLaneCounts())
		{
			FShaderHarness Harness = MakeHarness(Access);
			Harness.Run(Lanes, NumThreads, 1);
			Compare(Access, Harness, std::to_string(Lanes) + " lanes");
		}
		FShaderHarness Interpreted = MakeHarness(Access);
		Interpreted.RunModel(NumThreads, 1);
		Compare(Access, Interpreted, "interpreted");
		FShaderHarness LookedInto = MakeHarness(Access);
		LookedInto.RunInspected(NumThreads, 1);
		Compare(Access, LookedInto, "looked into");
	}
}

TEST(OutOfBounds, TheCheckNamesLineAndThread)
{
	for (const FAccess& Access : GetAccesses())
	{
		FShaderHarness Harness = MakeHarness(Access);
		FInspectedShader& Shader = Harness.Inspect();
		FCheckSet Checks;
		Checks.bOn.fill(true);
		std::vector<std::string> Found;
		for (const FCheckFinding& Finding :
			CheckThreads(Shader, MakeBound(Harness), Harness.GetArgs(), {0, 0, 0, NumThreads, 1, 1}, {}, Checks))
		{
			if (std::string(GetCheckName(Finding.Check)) == "bounds")
			{
				EXPECT_EQ(7, Finding.Line) << Access.Name;
				EXPECT_EQ(5, Finding.First[0]) << Access.Name;
				EXPECT_EQ(3u, Finding.Threads) << Access.Name;
				Found.push_back(Finding.What);
			}
		}
		EXPECT_EQ(std::vector<std::string>{Access.Finding}, Found) << Access.Name;
	}
}
