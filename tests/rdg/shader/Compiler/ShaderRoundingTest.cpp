// Arithmetic of floats is rounded as it is written, whatever an optimiser knows about literals: all forms of a shader
// give the bits of plain C++.
#include "ShaderForms.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

namespace Drydock::Test
{

namespace
{

constexpr int32_t NumThreads = 64;
constexpr size_t NumResults = 7;

const std::string Text = R"(
StructuredBuffer<float> In;
RWStructuredBuffer<float> Out;
float Scale(float X, float Factor) { return X * Factor; }
float Decode(float Code) { return exp2(Code * 3.0f) * 0.18f; }
[numthreads(8, 1, 1)]
void MainCS(uint3 Id : SV_DispatchThreadID)
{
	float X = In[Id.x];
	float Y = In[Id.x + 1];
	uint At = Id.x * 7;
	Out[At] = Scale(Scale(X, 0.1f), 0.7f);
	Out[At + 1] = X / 7.0f;
	Out[At + 2] = X * 0.3f + X * Y;
	Out[At + 3] = 1.1f + (X + 0.1f);
	Out[At + 4] = 0.3f / (0.7f / X);
	Out[At + 5] = Scale(X - Y, 0.0f);
	Out[At + 6] = Decode(0.0f) * Scale(0.1f, 0.3f) * X;
}
)";

/** Real rounds each operation. */
template<typename Real>
std::vector<float> Compute(float InX, float InY)
{
	const auto Number = [](float Literal)
	{
		return Real(Literal);
	};
	const Real X = InX;
	const Real Y = InY;
	const std::vector<Real> Results = {X * Number(0.1f) * Number(0.7f), X / Number(7.0f), X * Number(0.3f) + X * Y,
		Number(1.1f) + (X + Number(0.1f)), Number(0.3f) / (Number(0.7f) / X), (X - Y) * Number(0.0f),
		Number(0.18f) * (Number(0.1f) * Number(0.3f)) * X};
	return {Results.begin(), Results.end()};
}

/** D3D's compilers refuse literals of integers that are divided by 0. */
bool IsRefused(const std::string& Expression, int32_t B)
{
	return B == 0 && Expression.find_first_of("/%") != std::string::npos &&
		   Expression.find("float") == std::string::npos;
}

} // namespace

TEST(ShaderRounding, IsThatOfTheTextInEveryForm)
{
	std::vector<float> In;
	for (int32_t i = 0; i <= NumThreads; ++i)
	{
		In.push_back(float(i * i + 1) * (i % 3 == 0 ? -0.37f : 1.9f) / 11.0f);
	}
	In[5] = std::numeric_limits<float>::infinity();
	const auto Fill = [&](FShaderHarness& Harness)
	{
		Harness.SetFloatBuffer("In", In);
		Harness.Buffers["Out"].assign(NumThreads * NumResults, 0);
	};
	ForEachForm(Text, NumThreads, 1, 1, Fill,
		[&](FShaderHarness& Harness)
		{
			for (size_t i = 0; i < NumThreads; ++i)
			{
				const std::vector<float> Expected = Harness.Request.Lanes.bDouble ? Compute<double>(In[i], In[i + 1])
																				  : Compute<float>(In[i], In[i + 1]);
				for (size_t k = 0; k < NumResults; ++k)
				{
					const float Made = Harness.BufferFloat("Out", i * NumResults + k);
					EXPECT_TRUE(SameFloat(Expected[k], Made))
						<< "result " << k << " of " << In[i] << ": " << Made << ", not " << Expected[k];
				}
			}
		});
}

/** What a compiler knows already is what a thread would compute: of variables, of constants in functions, of literals.
 */
TEST(ShaderRounding, IntegersOfConstantsAreThoseOfVariables)
{
	const std::vector<std::string> Functions = {"A % B", "A % -B", "A / B", "A << B", "A >> B", "int(uint(A) >> B)",
		"int(uint(A) / uint(B))", "int(uint(A) % uint(B))", "int(float(A) / float(B))"};
	const std::vector<std::pair<int32_t, int32_t>> Pairs = {{-7, 4}, {7, 4}, {-8, 3}, {1, 31}, {-5, 30},
		{-2147483647 - 1, 3}, {1, 33}, {-5, 40}, {3, -1}, {7, 0}, {-2147483647 - 1, -1}};
	const auto WithLiterals = [](std::string Expression, int32_t A, int32_t B)
	{
		std::string Result;
		for (const char Sign : Expression)
		{
			Result += Sign == 'A'   ? "int(" + std::to_string(A) + ")"
					  : Sign == 'B' ? "(" + std::to_string(B) + ")"
									: std::string(1, Sign);
		}
		return Result;
	};
	std::string Text = "StructuredBuffer<int> In;\nRWStructuredBuffer<int> Out;\n";
	std::string Body;
	std::vector<uint32_t> In;
	int32_t Place = 0;
	for (size_t f = 0; f < Functions.size(); ++f)
	{
		const std::string Name = "F" + std::to_string(f);
		Text += "int " + Name + "(int A, int B) { return " + Functions[f] + "; }\n";
		for (const auto& [A, B] : Pairs)
		{
			const std::string First = std::to_string(In.size());
			In.push_back(uint32_t(A));
			In.push_back(uint32_t(B));
			for (const std::string& Result : {Name + "(In[" + First + "], In[" + std::to_string(In.size() - 1) + "])",
					 Name + "(int(" + std::to_string(A) + "), " + std::to_string(B) + ")",
					 IsRefused(Functions[f], B) ? Name + "(" + std::to_string(A) + ", 0)"
												: WithLiterals(Functions[f], A, B)})
			{
				Body += "\tOut[" + std::to_string(Place++) + "] = " + Result + ";\n";
			}
		}
	}
	Text += "[numthreads(1, 1, 1)]\nvoid MainCS()\n{\n" + Body + "}\n";
	const auto Fill = [&](FShaderHarness& Harness)
	{
		Harness.Buffers["In"] = In;
		Harness.Buffers["Out"].assign(size_t(Place), 0);
	};
	ForEachForm(Text, 1, 1, 1, Fill,
		[&](FShaderHarness& Harness)
		{
			const std::vector<uint32_t>& Out = Harness.Buffers["Out"];
			EXPECT_EQ(-3, int32_t(Out[0]));                           // -7 % 4
			EXPECT_EQ(0xFFFFFFFFu, Out[(2 * Pairs.size() + 9) * 3]);  // 7 / 0
			EXPECT_EQ(0x80000000u, Out[(2 * Pairs.size() + 10) * 3]); // the least number / -1
			EXPECT_EQ(2u, Out[(3 * Pairs.size() + 6) * 3]);           // 1 << 33
			EXPECT_EQ(0x80000000u, Out[(3 * Pairs.size() + 8) * 3]);  // 3 << -1
			for (size_t i = 0; i < Out.size(); i += 3)
			{
				const std::string Of = Functions[i / 3 / Pairs.size()] + " of " +
									   std::to_string(int32_t(In[i / 3 * 2])) + " and " +
									   std::to_string(int32_t(In[i / 3 * 2 + 1]));
				EXPECT_EQ(Out[i], Out[i + 1]) << Of << ", constants";
				if (Functions[i / 3 / Pairs.size()].find("float") == std::string::npos) // literals have no width
				{
					EXPECT_EQ(Out[i], Out[i + 2]) << Of << ", literals";
				}
			}
		});
}

TEST(ShaderRounding, SoAreThoseOf64Bits)
{
	const std::string Text = R"(
StructuredBuffer<int> In;
RWStructuredBuffer<uint> Out;
int64_t Divide(int64_t A, int64_t B) { return A / B; }
uint64_t Remain(uint64_t A, uint64_t B) { return A % B; }
void Store(uint At, uint64_t Value)
{
	Out[At * 2] = uint(Value);
	Out[At * 2 + 1] = uint(Value >> 32);
}
[numthreads(1, 1, 1)]
void MainCS()
{
	int64_t Least = int64_t(In[2]) << 63;
	Store(0, uint64_t(Divide(In[0], In[1])));
	Store(1, uint64_t(Divide(7ll, 0ll)));
	Store(2, Remain(uint64_t(In[0]), uint64_t(In[1])));
	Store(3, Remain(7ull, 0ull));
	Store(4, uint64_t(Divide(Least, -1ll)));
	Store(5, uint64_t(Divide(-9223372036854775807ll - 1ll, -1ll)));
	Store(6, uint64_t((-9223372036854775807ll - 1ll) / -1ll));
}
)";
	const auto Fill = [](FShaderHarness& Harness)
	{
		Harness.Buffers["In"] = {7, 0, 1};
		Harness.Buffers["Out"].assign(14, 0);
	};
	ForEachForm(Text, 1, 1, 1, Fill,
		[](FShaderHarness& Harness)
		{
			const std::vector<uint32_t>& Out = Harness.Buffers["Out"];
			for (size_t i = 0; i < 7; ++i)
			{
				const uint64_t Expected = i < 4 ? ~0ull : 1ull << 63; // all ones; the least number
				EXPECT_EQ(Expected, Out[i * 2] | uint64_t(Out[i * 2 + 1]) << 32) << "result " << i;
			}
		});
}

TEST(ShaderRounding, LiteralsDividedByZeroAreRefused)
{
	for (const std::string Expression : {"7 / 0", "7 % 0", "7u / 0u", "7ll / 0ll", "7ull % 0ull"})
	{
		FShaderHarness Harness("RWStructuredBuffer<uint> Out;\n[numthreads(1, 1, 1)]\nvoid MainCS()\n{\n\tOut[0] = "
							   "uint(" +
								   Expression + ");\n}\n",
			"MainCS", EShaderStage::Compute);
		Harness.Buffers["Out"].assign(1, 0);
		EXPECT_THAT(ErrorOf([&] { Harness.Run(0, 1, 1); }), testing::HasSubstr("X4010: division of an integer by zero"))
			<< Expression;
	}
}

} // namespace Drydock::Test
