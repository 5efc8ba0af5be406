// Computes functions of HLSL on constants by the operations of SPIR-V that they are written in.
#include "HlslConstantCalls.h"

#include "HlslConstantMath.h"
#include "SpirvOps.h"
#include "SpirvScalarMath.h"
#include "TileExecutor.h"

#include <algorithm>
#include <cmath>
#include <type_traits>

namespace Drydock::Hlsl
{

namespace
{

using FCallResult = std::optional<FConstant>;
using FCallArguments = std::vector<FConstantArgument>;

/** A function of single components: instructions of GLSL.std.450 by the scalar, 0 where there is none. */
struct FExtendedCall
{
	std::string_view Name;
	uint32_t Real;
	uint32_t Signed = 0;
	uint32_t Unsigned = 0;
};

constexpr FExtendedCall ExtendedCalls[] = {{"abs", Spirv::ExtFAbs, Spirv::ExtSAbs},
	{"sign", Spirv::ExtFSign, Spirv::ExtSSign}, {"floor", Spirv::ExtFloor}, {"ceil", Spirv::ExtCeil},
	{"trunc", Spirv::ExtTrunc}, {"round", Spirv::ExtRoundEven}, {"frac", Spirv::ExtFract}, {"sqrt", Spirv::ExtSqrt},
	{"rsqrt", Spirv::ExtInverseSqrt}, {"exp", Spirv::ExtExp}, {"exp2", Spirv::ExtExp2}, {"log", Spirv::ExtLog},
	{"log2", Spirv::ExtLog2}, {"sin", Spirv::ExtSin}, {"cos", Spirv::ExtCos}, {"tan", Spirv::ExtTan},
	{"asin", Spirv::ExtAsin}, {"acos", Spirv::ExtAcos}, {"atan", Spirv::ExtAtan}, {"sinh", Spirv::ExtSinh},
	{"cosh", Spirv::ExtCosh}, {"tanh", Spirv::ExtTanh}, {"degrees", Spirv::ExtDegrees}, {"radians", Spirv::ExtRadians},
	{"atan2", Spirv::ExtAtan2}, {"pow", Spirv::ExtPow}, {"step", Spirv::ExtStep}, {"lerp", Spirv::ExtFMix},
	{"smoothstep", Spirv::ExtSmoothStep}, {"min", Spirv::ExtFMin, Spirv::ExtSMin, Spirv::ExtUMin},
	{"max", Spirv::ExtFMax, Spirv::ExtSMax, Spirv::ExtUMax},
	{"clamp", Spirv::ExtFClamp, Spirv::ExtSClamp, Spirv::ExtUClamp},
	{"firstbithigh", 0, Spirv::ExtFindSMsb, Spirv::ExtFindUMsb},
	{"firstbitlow", 0, Spirv::ExtFindILsb, Spirv::ExtFindILsb}};

/** The bits of a number that is exact in the scalar. */
uint64_t GetCallNumber(EScalar Scalar, double Number)
{
	return ConvertConstantBits(EScalar::LiteralFloat, Scalar, __builtin_bit_cast(uint64_t, Number));
}

/** One component of a function that goes by components; false: it is none. */
bool EvaluateComponent(std::string_view Name, EScalar From, EScalar To, const uint64_t* Bits, uint64_t& Result)
{
	const bool bReal = IsReal(From);
	for (const FExtendedCall& Call : ExtendedCalls)
	{
		const uint32_t Ext = bReal ? Call.Real : IsUnsigned(From) ? Call.Unsigned : Call.Signed;
		if (Call.Name == Name && Ext != 0)
		{
			const bool bKnown = EvaluateConstantExtended(Ext, From, Bits, Result);
			const uint32_t Width = 8 * GetSpirvBytes(GetConstantKind(From));
			const bool bNone = Name.starts_with("firstbit") && Result == UINT64_MAX >> (64 - Width);
			Result = bNone ? UINT32_MAX : ConvertConstantBits(From, To, Result);
			return bKnown;
		}
	}
	const auto Operate = [From, To](uint16_t Op, uint64_t A, uint64_t B = 0)
	{
		const uint64_t Pair[3] = {A, B, 0};
		uint64_t Made = 0;
		EvaluateConstant(Op, From, To, Pair, Made);
		return Made;
	};
	const auto Calculate = [From, &Operate](std::string_view Operator, uint64_t A, uint64_t B)
	{
		return Operate(FindConstantOperation(Operator, From), A, B);
	};
	const uint64_t One = bReal ? GetCallNumber(From, 1) : 0;
	const auto Extend = [From](uint32_t Ext, uint64_t A, uint64_t B, uint64_t C)
	{
		const uint64_t Words[3] = {A, B, C};
		uint64_t Made = 0;
		EvaluateConstantExtended(Ext, From, Words, Made);
		return Made;
	};
	const auto Is = [Name](auto... Names)
	{
		return ((Name == Names) || ...);
	};
	const uint64_t A = Bits[0];
	const uint64_t B = Bits[1];
	bool bKnown = true;
	// clang-format off
	Result = Is("rcp") ? Calculate("/", One, A)
		: Is("fmod") ? Calculate("%", A, B)
		: Is("mad", "fma") ? Calculate("+", Calculate("*", A, B), Bits[2])
		: Is("ldexp") ? Calculate("*", A, Extend(Spirv::ExtExp2, B, 0, 0))
		: Is("saturate") ? Extend(Spirv::ExtFClamp, A, 0, One)
		: Is("log10") ? Calculate("*", Extend(Spirv::ExtLog2, A, 0, 0), GetCallNumber(From, 0.30102999566398119521))
		: Is("isnan") ? Operate(Spirv::OpIsNan, A)
		: Is("isinf") ? Operate(Spirv::OpIsInf, A)
		: Is("isfinite") ? !Operate(Spirv::OpIsNan, A) && !Operate(Spirv::OpIsInf, A)
		: Is("and") ? A && B
		: Is("or") ? A || B
		: Is("select") ? (A ? B : Bits[2])
		: Is("sign") ? A != 0
		: Is("countbits") ? Operate(Spirv::OpBitCount, A)
		: Is("reversebits") ? Operate(Spirv::OpBitReverse, A)
		: Is("f16tof32") ? FromSpirvMemory<float>(ESpirvType::Half, A & 0xFFFF)
		: Is("f32tof16") ? ToSpirvMemory<float>(ESpirvType::Half, A)
		: Is("asdouble") ? B << 32 | A
		: Is("abs", "asfloat", "asint", "asuint", "asfloat16", "asint16", "asuint16", "NonUniformResourceIndex") ? A
		: (bKnown = false, 0);
	// clang-format on
	return bKnown;
}

/** Functions of whole vectors and matrices, in one kind of number: float (half too: rounded once, at the end), double,
 * or 64 bits for integers, whose low bits are those of the narrower ones. */
template<typename Number>
class TWholeCall
{
public:
	TWholeCall(const FType* InResult, const FCallArguments& Arguments)
		: Result(InResult)
	{
		for (const FConstantArgument& Argument : Arguments)
		{
			std::vector<Number>& Values = Parts.emplace_back();
			for (const uint64_t Bits : *Argument.Bits)
			{
				Values.push_back(Load(Argument.Type->Scalar, Bits));
			}
			Types.push_back(Argument.Type);
		}
	}

	FCallResult Evaluate(std::string_view Name)
	{
		const size_t Count = Parts.size();
		const bool bReal = !std::is_same_v<Number, uint64_t>;
		if (Name == "mul" && Count == 2)
		{
			return Multiply();
		}
		if (Name == "dot" && Count == 2)
		{
			return Give({Dot(Parts[0], Parts[1])});
		}
		if constexpr (bReal)
		{
			return EvaluateReal(Name, Count);
		}
		return std::nullopt;
	}

private:
	using FNumbers = std::vector<Number>;

	static Number Load(EScalar Scalar, uint64_t Bits)
	{
		if constexpr (std::is_same_v<Number, uint64_t>)
		{
			return Bits;
		}
		else
		{
			return ToSpirvReal<Number>(FromSpirvMemory<float>(GetConstantKind(Scalar), Bits));
		}
	}

	FCallResult Give(const FNumbers& Values) const
	{
		FConstant Constant;
		const ESpirvType Kind = GetConstantKind(Result->Scalar);
		for (const Number Value : Values)
		{
			uint64_t Word = 0;
			if constexpr (std::is_same_v<Number, uint64_t>)
			{
				Word = GetSpirvBytes(Kind) == 4 ? uint32_t(Value) : Value;
			}
			else
			{
				Word = ToSpirvWord<Number>(Value);
			}
			Constant.push_back(ToSpirvMemory<float>(Kind, NarrowSpirv<float>(Kind, Word)));
		}
		return Constant;
	}

	static Number Dot(const FNumbers& A, const FNumbers& B)
	{
		Number Sum = A[0] * B[0];
		for (size_t i = 1; i < std::min(A.size(), B.size()); ++i)
		{
			Sum += A[i] * B[i];
		}
		return Sum;
	}

	FCallResult Multiply() const
	{
		FNumbers Values;
		if (Types[0]->IsScalar() || Types[1]->IsScalar())
		{
			const size_t Scalar = Types[0]->IsScalar() ? 0 : 1;
			for (const Number Value : Parts[1 - Scalar])
			{
				Values.push_back(Value * Parts[Scalar][0]);
			}
			return Give(Values);
		}
		// A vector stands as a row on the left, as a column on the right.
		const size_t Inner = Types[0]->Columns;
		const size_t Rows = Types[0]->IsMatrix() ? Types[0]->Rows : 1;
		const size_t Columns = Types[1]->IsMatrix() ? Types[1]->Columns : 1;
		if (Parts[1].size() != Inner * Columns)
		{
			return std::nullopt;
		}
		for (size_t i = 0; i < Rows * Columns; ++i)
		{
			const size_t Row = i / Columns;
			const size_t Column = i % Columns;
			Number Sum = Parts[0][Row * Inner] * Parts[1][Column];
			for (size_t k = 1; k < Inner; ++k)
			{
				Sum += Parts[0][Row * Inner + k] * Parts[1][k * Columns + Column];
			}
			Values.push_back(Sum);
		}
		return Give(Values);
	}

	template<typename F>
	FCallResult Each(F Function) const
	{
		FNumbers Values;
		for (size_t i = 0; i < Parts[0].size(); ++i)
		{
			Values.push_back(Function(i));
		}
		return Give(Values);
	}

	static FNumbers Cross(const Number* A, const Number* B)
	{
		return {A[1] * B[2] - A[2] * B[1], A[2] * B[0] - A[0] * B[2], A[0] * B[1] - A[1] * B[0]};
	}

	static Number Length(const FNumbers& A) { return A.size() == 1 ? std::fabs(A[0]) : std::sqrt(Dot(A, A)); }

	static Number Determinant(const FNumbers& M)
	{
		switch (M.size())
		{
		case 1:
			return M[0];
		case 4:
			return M[0] * M[3] - M[1] * M[2];
		case 9:
			return Dot(M, Cross(M.data() + 3, M.data() + 6));
		default:
			break;
		}
		const auto Minor = [&M](size_t Row, size_t A, size_t B)
		{
			return M[Row * 4 + A] * M[Row * 4 + 4 + B] - M[Row * 4 + B] * M[Row * 4 + 4 + A];
		};
		return Minor(0, 0, 1) * Minor(2, 2, 3) - Minor(0, 0, 2) * Minor(2, 1, 3) + Minor(0, 0, 3) * Minor(2, 1, 2) +
			   Minor(0, 1, 2) * Minor(2, 0, 3) - Minor(0, 1, 3) * Minor(2, 0, 2) + Minor(0, 2, 3) * Minor(2, 0, 1);
	}

	FCallResult EvaluateReal(std::string_view Name, size_t Count)
	{
		const FNumbers& A = Parts[0];
		const FNumbers& B = Parts[Count > 1 ? 1 : 0];
		const FNumbers& C = Parts[Count > 2 ? 2 : 0];
		if (Name == "length")
		{
			return Give({Length(A)});
		}
		if (Name == "distance" && Count == 2)
		{
			FNumbers Difference;
			for (size_t i = 0; i < A.size(); ++i)
			{
				Difference.push_back(A[i] - B[i]);
			}
			return Give({Length(Difference)});
		}
		if (Name == "normalize")
		{
			const Number Inverse = Number(1) / std::sqrt(Dot(A, A));
			const bool bOne = A.size() == 1;
			return Each([&](size_t i) { return bOne ? Number((A[0] > 0) - (A[0] < 0)) : A[i] * Inverse; });
		}
		if (Name == "cross" && Count == 2 && A.size() == 3)
		{
			return Give(Cross(A.data(), B.data()));
		}
		if (Name == "determinant" && A.size() == size_t(Types[0]->Rows) * Types[0]->Rows)
		{
			return Give({Determinant(A)});
		}
		if (Name == "reflect" && Count == 2)
		{
			const Number Twice = Dot(B, A) + Dot(B, A);
			return Each([&](size_t i) { return A[i] - B[i] * Twice; });
		}
		if (Name == "refract" && Count == 3)
		{
			const Number Cosine = Dot(B, A);
			const Number Eta = C[0];
			const Number K = Number(1) - Eta * Eta * (Number(1) - Cosine * Cosine);
			const Number Factor = Eta * Cosine + std::sqrt(K > 0 ? K : Number(0));
			return Each([&](size_t i) { return K < 0 ? Number(0) : A[i] * Eta - B[i] * Factor; });
		}
		if (Name == "faceforward" && Count == 3)
		{
			const bool bFacing = Dot(C, B) < 0;
			return Each([&](size_t i) { return bFacing ? A[i] : -A[i]; });
		}
		if (Name == "dst" && Count == 2)
		{
			return Give({Number(1), A[1] * B[1], A[2], B[3]});
		}
		if (Name == "lit" && Count == 3)
		{
			const bool bDark = A[0] < 0 || B[0] < 0;
			const uint64_t Words[3] = {ToSpirvWord<Number>(B[0]), ToSpirvWord<Number>(C[0]), 0};
			uint64_t Power = 0;
			EvaluateExtended<Number>(Spirv::ExtPow, Words, Power);
			const Number Shine = bDark ? Number(0) : ToSpirvReal<Number>(Power);
			return Give({Number(1), A[0] > 0 ? A[0] : Number(0), Shine, Number(1)});
		}
		return std::nullopt;
	}

	const FType* const Result;
	std::vector<FNumbers> Parts;
	std::vector<const FType*> Types;
};

FCallResult EvaluateWholeCall(std::string_view Name, const FType* Result, const FCallArguments& Arguments)
{
	const FConstantArgument& First = Arguments[0];
	if (Name == "any" || Name == "all")
	{
		bool bAny = false;
		bool bAll = true;
		for (const uint64_t Bits : *First.Bits)
		{
			bAny = bAny || Bits != 0;
			bAll = bAll && Bits != 0;
		}
		return FConstant{Name == "any" ? bAny : bAll};
	}
	if (Name == "transpose")
	{
		FConstant Turned;
		for (size_t i = 0; i < First.Bits->size(); ++i)
		{
			Turned.push_back(First.Bits->at(i % First.Type->Rows * First.Type->Columns + i / First.Type->Rows));
		}
		return Turned;
	}
	const ESpirvType Kind = GetConstantKind(First.Type->Scalar);
	const FScopedDenormals Denormals(Kind == ESpirvType::Double ? EDenormals::Keep : EDenormals::Flush);
	return !IsReal(First.Type->Scalar)  ? TWholeCall<uint64_t>(Result, Arguments).Evaluate(Name)
		   : Kind == ESpirvType::Double ? TWholeCall<double>(Result, Arguments).Evaluate(Name)
										: TWholeCall<float>(Result, Arguments).Evaluate(Name);
}

} // namespace

std::optional<FConstant> EvaluateConstantCall(
	std::string_view Name, const FType* Result, const std::vector<FConstantArgument>& Arguments)
{
	if (Arguments.empty() || Arguments.size() > 3)
	{
		return std::nullopt;
	}
	if (FCallResult Whole = EvaluateWholeCall(Name, Result, Arguments))
	{
		return Whole;
	}
	FConstant Constant;
	for (size_t i = 0; i < Result->NumComponents(); ++i)
	{
		uint64_t Bits[3] = {};
		for (size_t k = 0; k < Arguments.size(); ++k)
		{
			const FConstant& Given = *Arguments[k].Bits;
			const size_t At = Given.size() == 1 ? 0 : i;
			if (At >= Given.size())
			{
				return std::nullopt;
			}
			Bits[k] = Given[At];
		}
		uint64_t Made = 0;
		if (!EvaluateComponent(Name, Arguments[0].Type->Scalar, Result->Scalar, Bits, Made))
		{
			return std::nullopt;
		}
		Constant.push_back(Made);
	}
	return Constant;
}

} // namespace Drydock::Hlsl
