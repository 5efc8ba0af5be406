// Instructions of other front ends, dxc's above all: modules are assembled here, and what they compute is held against
// the definitions of the SPIR-V specification and of GLSL.std.450, written out in plain C++.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "CacheTestUtils.h"
#include "SpirvFile.h"

#include <spirv-tools/libspirv.hpp>

#include <bit>
#include <cmath>
#include <limits>
#include <random>

namespace
{

using namespace Drydock;
using namespace Drydock::Test;
using testing::HasSubstr;

constexpr size_t GThreads = 128;
constexpr size_t GOperands = 4; // words that each thread reads: %a to %d

using FOperands = std::array<uint32_t, GOperands>;
using FResults = std::vector<uint32_t>;

/** A compute shader whose threads write the words %r0, %r1, ... of Body. */
std::string MakeText(const std::string& Body, size_t NumResults, const std::string& Globals = "")
{
	std::string Text = R"(
OpCapability Shader
%ext = OpExtInstImport "GLSL.std.450"
OpMemoryModel Logical GLSL450
OpEntryPoint GLCompute %main "Main" %gid
OpExecutionMode %main LocalSize 8 1 1
OpName %main "Main"
OpName %in "In"
OpName %out "Out"
OpDecorate %gid BuiltIn GlobalInvocationId
OpDecorate %words ArrayStride 4
OpMemberDecorate %in_t 0 Offset 0
OpMemberDecorate %in_t 0 NonWritable
OpMemberDecorate %out_t 0 Offset 0
OpDecorate %in_t BufferBlock
OpDecorate %out_t BufferBlock
OpDecorate %in DescriptorSet 0
OpDecorate %in Binding 0
OpDecorate %out DescriptorSet 0
OpDecorate %out Binding 1
%void = OpTypeVoid
%fn = OpTypeFunction %void
%uint = OpTypeInt 32 0
%int = OpTypeInt 32 1
%float = OpTypeFloat 32
%v2uint = OpTypeVector %uint 2
%v3uint = OpTypeVector %uint 3
%v2float = OpTypeVector %float 2
%v4float = OpTypeVector %float 4
%pair = OpTypeStruct %uint %uint
%pair2 = OpTypeStruct %v2uint %v2uint
%frexp = OpTypeStruct %float %int
%v2int = OpTypeVector %int 2
%frexp2 = OpTypeStruct %v2float %v2int
%modf = OpTypeStruct %float %float
%words = OpTypeRuntimeArray %uint
%in_t = OpTypeStruct %words
%out_t = OpTypeStruct %words
%p_in = OpTypePointer Uniform %in_t
%p_out = OpTypePointer Uniform %out_t
%p_uint = OpTypePointer Uniform %uint
%p_v3 = OpTypePointer Input %v3uint
%p_float = OpTypePointer Function %float
%fn_float = OpTypeFunction %float %float
%in = OpVariable %p_in Uniform
%out = OpVariable %p_out Uniform
%gid = OpVariable %p_v3 Input
)";
	for (int i = 0; i < 9; ++i)
	{
		Text += "%c" + std::to_string(i) + " = OpConstant %uint " + std::to_string(i) + "\n";
	}
	Text += Globals + "\n%count = OpConstant %uint " + std::to_string(NumResults) +
			"\n%main = OpFunction %void None %fn\n%entry = OpLabel\n%id = OpLoad %v3uint %gid\n"
			"%x = OpCompositeExtract %uint %id 0\n%from = OpIMul %uint %x %c4\n%to = OpIMul %uint %x %count\n";
	for (size_t i = 0; i < GOperands; ++i)
	{
		const std::string Name(1, char('a' + i));
		const std::string Number = std::to_string(i);
		Text += "%at_" + Name + " = OpIAdd %uint %from %c" + Number + "\n%p" + Name +
				" = OpAccessChain %p_uint %in %c0 %at_" + Name + "\n%" + Name + " = OpLoad %uint %p" + Name + "\n%f" +
				Name + " = OpBitcast %float %" + Name + "\n";
	}
	Text += Body + "\n";
	for (size_t i = 0; i < NumResults; ++i)
	{
		const std::string Number = std::to_string(i);
		Text += "%o" + Number + " = OpIAdd %uint %to %c" + Number + "\n%q" + Number +
				" = OpAccessChain %p_uint %out %c0 %o" + Number + "\nOpStore %q" + Number + " %r" + Number + "\n";
	}
	return Text + "OpReturn\nOpFunctionEnd\n";
}

std::string Assemble(const std::string& Text, bool bValid = true)
{
	spvtools::SpirvTools Tools(SPV_ENV_UNIVERSAL_1_0);
	std::string Errors;
	Tools.SetMessageConsumer([&Errors](spv_message_level_t, const char*, const spv_position_t& At, const char* Message)
		{ Errors += std::to_string(At.index) + ": " + Message + "\n"; });
	std::vector<uint32_t> Words;
	EXPECT_TRUE(Tools.Assemble(Text, &Words) && (Tools.Validate(Words) || !bValid)) << Errors << Text;
	return {reinterpret_cast<const char*>(Words.data()), Words.size() * sizeof(uint32_t)};
}

class FSpirvInstructions : public testing::Test
{
protected:
	FSpirvInstructions() { AddShaderDirectory("/SpirvInstructions", Folder.Path.string()); }
	~FSpirvInstructions() override { ForgetShaderDirectories(NumDirectories); }

	FShaderHarness MakeHarness(const std::vector<FOperands>& In, size_t NumResults)
	{
		FShaderHarness Harness("", "Main", EShaderStage::Compute);
		Harness.Request.VirtualPath = "/SpirvInstructions/Module.spv";
		Harness.Request.GeneratedFiles.clear();
		for (const FOperands& Each : In)
		{
			Harness.Buffers["In"].insert(Harness.Buffers["In"].end(), Each.begin(), Each.end());
		}
		Harness.Buffers["Out"].assign(In.size() * NumResults, 0xCDCDCDCD);
		return Harness;
	}

	/** Check(operands, results) of each thread, by kernels of every width, in double, and by the interpreter. */
	template<typename F>
	void Run(const std::string& Text, const std::vector<FOperands>& In, size_t NumResults, F Check)
	{
		Folder.Add("Module.spv", Assemble(Text));
		ForgetCompiledShaders();
		const auto RunForm = [&](const std::string& Form, auto RunIt)
		{
			SCOPED_TRACE(Form);
			FShaderHarness Harness = MakeHarness(In, NumResults);
			RunIt(Harness);
			for (size_t i = 0; i < In.size() && !HasFailure(); ++i)
			{
				const auto First = Harness.Buffers["Out"].begin() + ptrdiff_t(i * NumResults);
				Check(In[i], FResults(First, First + ptrdiff_t(NumResults)));
			}
		};
		const int32_t Threads = int32_t(In.size());
		for (const int32_t Lanes : GetLaneCounts())
		{
			RunForm(std::to_string(Lanes) + " lanes", [&](FShaderHarness& H) { H.Run(Lanes, Threads, 1); });
		}
		RunForm("double", [&](FShaderHarness& H) { H.Run(0, Threads, 1, 1, true); });
		RunForm("interpreter", [&](FShaderHarness& H) { H.RunModel(Threads, 1); });
		RunForm("with its functions", [&](FShaderHarness& H) { H.RunInspected(Threads, 1); });
	}

	/** The results have the words that Expect(operands) gives. */
	template<typename F>
	void ExpectWords(const std::string& Body, const std::vector<FOperands>& In, size_t NumResults, F Expect)
	{
		Run(MakeText(Body, NumResults), In, NumResults,
			[&](const FOperands& Operands, const FResults& Results)
			{ EXPECT_EQ(Expect(Operands), Results) << testing::PrintToString(Operands) << Body; });
	}

	const size_t NumDirectories = CountShaderDirectories();
	const FScratchFolder Folder;
	const FScopedVariable Cache{"DRYDOCK_CACHE_DIR", (Folder.Path / "cache").string()};
};

std::mt19937 GRandom(5);

/** Any words; %c and %d are the offset and the count of a bit field that lies within a word. */
std::vector<FOperands> MakeFields()
{
	std::vector<FOperands> In;
	for (uint32_t i = 0; i < GThreads; ++i)
	{
		const uint32_t Offset = i == 0 ? 0 : GRandom() % 32;
		const uint32_t Count = i == 0 ? 32 : GRandom() % (33 - Offset);
		In.push_back({uint32_t(GRandom()), uint32_t(GRandom()), Offset, Count});
	}
	return In;
}

std::vector<FOperands> MakeReals(const std::vector<float>& Special, float Least, float Most)
{
	std::vector<FOperands> In;
	std::uniform_real_distribution<float> Real(Least, Most);
	for (size_t i = 0; i < GThreads; ++i)
	{
		FOperands& Each = In.emplace_back();
		for (size_t k = 0; k < GOperands; ++k)
		{
			Each[k] = std::bit_cast<uint32_t>(i + k < Special.size() ? Special[i + k] : Real(GRandom));
		}
	}
	return In;
}

float Real(uint32_t Word)
{
	return std::bit_cast<float>(Word);
}

bool IsIn(uint32_t Bit, uint32_t Offset, uint32_t Count)
{
	return Bit >= Offset && Bit < Offset + Count;
}

uint32_t Insert(uint32_t Base, uint32_t Inserted, uint32_t Offset, uint32_t Count)
{
	uint32_t Result = 0;
	for (uint32_t Bit = 0; Bit < 32; ++Bit)
	{
		Result |= (IsIn(Bit, Offset, Count) ? Inserted >> (Bit - Offset) & 1 : Base >> Bit & 1) << Bit;
	}
	return Result;
}

uint32_t Extract(uint32_t Base, uint32_t Offset, uint32_t Count, bool bSigned)
{
	uint32_t Result = 0;
	for (uint32_t Bit = 0; Bit < 32 && Count > 0; ++Bit)
	{
		Result |= (Bit < Count ? Base >> (Offset + Bit) & 1 : bSigned ? Base >> (Offset + Count - 1) & 1 : 0) << Bit;
	}
	return Result;
}

} // namespace

TEST_F(FSpirvInstructions, BitFields)
{
	ExpectWords(R"(
%sa = OpBitcast %int %a
%sb = OpBitcast %int %b
%r0 = OpBitFieldInsert %uint %a %b %c %d
%r1 = OpBitFieldUExtract %uint %a %c %d
%s2 = OpBitFieldSExtract %int %sa %c %d
%r2 = OpBitcast %uint %s2
%s3 = OpBitFieldInsert %int %sa %sb %c %d
%r3 = OpBitcast %uint %s3
%ab = OpCompositeConstruct %v2uint %a %b
%ba = OpCompositeConstruct %v2uint %b %a
%s4 = OpBitFieldInsert %v2uint %ab %ba %c5 %c7
%r4 = OpCompositeExtract %uint %s4 1
%s5 = OpBitFieldUExtract %v2uint %ab %c %d
%r5 = OpCompositeExtract %uint %s5 1
%r6 = OpBitFieldUExtract %uint %c7 %c1 %c1)",
		MakeFields(), 7,
		[](const FOperands& In) -> FResults
		{
			const auto& [A, B, Offset, Count] = In;
			return {Insert(A, B, Offset, Count), Extract(A, Offset, Count, false), Extract(A, Offset, Count, true),
				Insert(A, B, Offset, Count), Insert(B, A, 5, 7), Extract(B, Offset, Count, false), 1};
		});
}

TEST_F(FSpirvInstructions, CarriesAndBorrows)
{
	std::vector<FOperands> In = MakeFields();
	In[1] = {~0u, 1, ~0u, ~0u};
	In[2] = {5, 5, 0, 0};
	ExpectWords(R"(
%s0 = OpIAddCarry %pair %a %b
%r0 = OpCompositeExtract %uint %s0 0
%r1 = OpCompositeExtract %uint %s0 1
%s1 = OpISubBorrow %pair %a %b
%r2 = OpCompositeExtract %uint %s1 0
%r3 = OpCompositeExtract %uint %s1 1
%ab = OpCompositeConstruct %v2uint %a %b
%cd = OpCompositeConstruct %v2uint %c %d
%s2 = OpIAddCarry %pair2 %ab %cd
%r4 = OpCompositeExtract %uint %s2 0 1
%r5 = OpCompositeExtract %uint %s2 1 1
%s3 = OpISubBorrow %pair2 %cd %ab
%r6 = OpCompositeExtract %uint %s3 1 0)",
		In, 7,
		[](const FOperands& Words) -> FResults
		{
			const uint64_t A = Words[0], B = Words[1], C = Words[2], D = Words[3];
			return {uint32_t(A + B), uint32_t((A + B) >> 32), uint32_t(A - B), A < B, uint32_t(B + D),
				uint32_t((B + D) >> 32), C < A};
		});
}

TEST_F(FSpirvInstructions, PartsOfNumbersInStructs)
{
	const std::vector<float> Special = {0.0f, -0.0f, 1.0f, -0.5f, 0.75f, 3.0e38f, -1.5e-38f, 1023.99994f, -7.25f};
	ExpectWords(R"(
%s0 = OpExtInst %frexp %ext FrexpStruct %fa
%t0 = OpCompositeExtract %float %s0 0
%r0 = OpBitcast %uint %t0
%t1 = OpCompositeExtract %int %s0 1
%r1 = OpBitcast %uint %t1
%v = OpCompositeConstruct %v2float %fb %fc
%s1 = OpExtInst %frexp2 %ext FrexpStruct %v
%t2 = OpCompositeExtract %float %s1 0 1
%r2 = OpBitcast %uint %t2
%t3 = OpCompositeExtract %int %s1 1 0
%r3 = OpBitcast %uint %t3
%s2 = OpExtInst %modf %ext ModfStruct %fa
%t4 = OpCompositeExtract %float %s2 0
%t5 = OpCompositeExtract %float %s2 1
%zero = OpBitcast %float %c0
%z4 = OpFAdd %float %t4 %zero
%r4 = OpBitcast %uint %z4
%r5 = OpBitcast %uint %t5)",
		MakeReals(Special, -2000, 2000), 6,
		[](const FOperands& In) -> FResults
		{
			int Exponents[3];
			const float A = std::frexp(Real(In[0]), &Exponents[0]);
			std::frexp(Real(In[1]), &Exponents[1]);
			const float C = std::frexp(Real(In[2]), &Exponents[2]);
			float Whole;
			const float Part = std::modf(Real(In[0]), &Whole) + 0.0f; // the sign of a fraction of 0 is not told
			return {std::bit_cast<uint32_t>(A), uint32_t(Exponents[0]), std::bit_cast<uint32_t>(C),
				uint32_t(Exponents[1]), std::bit_cast<uint32_t>(Part), std::bit_cast<uint32_t>(Whole)};
		});
}

TEST_F(FSpirvInstructions, NormsArePacked)
{
	std::string Body = "%v2 = OpCompositeConstruct %v2float %fa %fb\n"
					   "%v4 = OpCompositeConstruct %v4float %fa %fb %fc %fd\n";
	const char* const Names[] = {"PackSnorm4x8 %v4", "PackUnorm4x8 %v4", "PackSnorm2x16 %v2", "PackUnorm2x16 %v2"};
	for (size_t i = 0; i < 4; ++i)
	{
		Body += "%r" + std::to_string(i) + " = OpExtInst %uint %ext " + Names[i] + "\n";
	}
	std::vector<FOperands> In = MakeReals({0, 1, -1, 2, -3, 0.5f, -0.5f, 0.25f, 1e30f, -1e30f}, -1.25f, 1.25f);
	for (FOperands& Each : In)
	{
		for (uint32_t& Word : Each) // so few bits that the products are exact, in double as in float
		{
			Word = std::bit_cast<uint32_t>(std::nearbyint(Real(Word) * 256) / 256);
		}
	}
	ExpectWords(Body, In, 4,
		[](const FOperands& Words) -> FResults
		{
			const auto Pack = [&Words](size_t Count, float Least, float One)
			{
				uint32_t Word = 0;
				for (size_t i = 0; i < Count; ++i)
				{
					const float Code = std::nearbyint(std::min(std::max(Real(Words[i]), Least), 1.0f) * One);
					const uint32_t Bits = 32 / uint32_t(Count);
					Word |= (uint32_t(int32_t(Code)) & ((1u << Bits) - 1)) << (i * Bits);
				}
				return Word;
			};
			return {Pack(4, -1, 127), Pack(4, 0, 255), Pack(2, -1, 32767), Pack(2, 0, 65535)};
		});
}

TEST_F(FSpirvInstructions, NormsAreUnpacked)
{
	std::vector<FOperands> In = MakeFields();
	In[0][0] = 0x80FF7F00;
	const char* const Names[] = {"%v4float %ext UnpackSnorm4x8", "%v4float %ext UnpackUnorm4x8",
		"%v2float %ext UnpackSnorm2x16", "%v2float %ext UnpackUnorm2x16"};
	std::string Body;
	for (size_t i = 0; i < 4; ++i)
	{
		const std::string Number = std::to_string(i);
		const std::string Last = i < 2 ? "3" : "1";
		Body += "%s" + Number + " = OpExtInst " + Names[i] + " %a\n%t" + Number + " = OpCompositeExtract %float %s" +
				Number + " 0\n%u" + Number + " = OpCompositeExtract %float %s" + Number + " " + Last + "\n%r" +
				std::to_string(2 * i) + " = OpBitcast %uint %t" + Number + "\n%r" + std::to_string(2 * i + 1) +
				" = OpBitcast %uint %u" + Number + "\n";
	}
	ExpectWords(Body, In, 8,
		[](const FOperands& Words) -> FResults
		{
			const uint32_t A = Words[0];
			const auto Give = [](float Code, float One)
			{
				return std::bit_cast<uint32_t>(std::max(Code / One, -1.0f));
			};
			return {Give(int8_t(A), 127), Give(int8_t(A >> 24), 127), Give(uint8_t(A), 255),
				Give(uint8_t(A >> 24), 255), Give(int16_t(A), 32767), Give(int16_t(A >> 16), 32767),
				Give(uint16_t(A), 65535), Give(uint16_t(A >> 16), 65535)};
		});
}

TEST_F(FSpirvInstructions, InverseHyperbolicsStayWithinFourUlp)
{
	const float Inf = std::numeric_limits<float>::infinity();
	const std::string Body = R"(
%s0 = OpExtInst %float %ext Asinh %fa
%s1 = OpExtInst %float %ext Acosh %fb
%s2 = OpExtInst %float %ext Atanh %fc
%r0 = OpBitcast %uint %s0
%r1 = OpBitcast %uint %s1
%r2 = OpBitcast %uint %s2)";
	std::vector<FOperands> In;
	std::uniform_real_distribution<float> Exponent(-60, 60);
	for (size_t i = 0; i < GThreads; ++i)
	{
		const float Size = std::exp2(Exponent(GRandom));
		const float Signed = i % 2 ? Size : -Size;
		In.push_back({std::bit_cast<uint32_t>(Signed), std::bit_cast<uint32_t>(1 + Size),
			std::bit_cast<uint32_t>(Signed / (1 + Size)), 0});
	}
	const std::vector<float> Special = {0, 1, -1, 1.5e38f, Inf, std::nanf(""), 0.5f, -2, 2};
	for (size_t i = 0; i < Special.size(); ++i)
	{
		std::fill_n(In[i].begin(), 3, std::bit_cast<uint32_t>(Special[i]));
	}
	Run(MakeText(Body, 3), In, 3,
		[](const FOperands& Operands, const FResults& Results)
		{
			const double Expected[] = {std::asinh(double(Real(Operands[0]))), std::acosh(double(Real(Operands[1]))),
				std::atanh(double(Real(Operands[2])))};
			for (size_t i = 0; i < 3; ++i)
			{
				const double Actual = double(Real(Results[i]));
				const double Ulp = std::fabs(Expected[i]) * 0x1p-23 + 0x1p-149;
				const bool bSame = std::isfinite(Expected[i]) ? std::fabs(Actual - Expected[i]) <= 4 * Ulp
								   : std::isnan(Expected[i])  ? std::isnan(Actual)
															  : Actual == Expected[i];
				EXPECT_TRUE(bSame) << "function " << i << " of " << Real(Operands[i]) << ": " << Actual << ", not "
								   << Expected[i];
			}
		});
}

TEST_F(FSpirvInstructions, CallsAreInlinedAlsoWhereTheModuleAsksForNone)
{
	const std::string Twice = R"(
%twice = OpFunction %float DontInline %fn_float
%given = OpFunctionParameter %float
%first = OpLabel
%small = OpFOrdLessThan %bool %given %one
OpSelectionMerge %rest None
OpBranchConditional %small %early %rest
%early = OpLabel
OpReturnValue %one
%rest = OpLabel
%made = OpFAdd %float %given %given
OpReturnValue %made
OpFunctionEnd
)";
	const std::string Text = MakeText("%t = OpFunctionCall %float %twice %fa\n%r0 = OpBitcast %uint %t", 1,
								 "%bool = OpTypeBool\n%one = OpConstant %float 1") +
							 Twice;
	Run(Text, MakeReals({0.5f, 1, 3}, -4, 4), 1,
		[](const FOperands& In, const FResults& Out)
		{ EXPECT_EQ(Real(In[0]) < 1 ? 1 : 2 * Real(In[0]), Real(Out[0])); });
}

TEST_F(FSpirvInstructions, UndefinedPointersMayStandButNotBeRead)
{
	const std::string Globals = "%nowhere = OpUndef %p_float";
	const std::string Body = "%here = OpUndef %p_float\n%r0 = OpIAdd %uint %a %b";
	Run(MakeText(Body, 1, Globals), MakeFields(), 1,
		[](const FOperands& In, const FResults& Out) { EXPECT_EQ(In[0] + In[1], Out[0]); });
	Folder.Add(
		"Module.spv", Assemble(MakeText("%t = OpLoad %float %nowhere\n%r0 = OpBitcast %uint %t", 1, Globals), false));
	ForgetCompiledShaders();
	EXPECT_THAT(
		ErrorOf([&] { MakeHarness(MakeFields(), 1).Run(0, 1, 1); }), HasSubstr("Op61 has operands that do not fit"));
}
