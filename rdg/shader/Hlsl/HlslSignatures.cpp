// Matches a call's arguments with signatures of the language of HlslIntrinsicTable.h, and names the expected ones.
#include "HlslIntrinsicTable.h"

#include "HlslConversions.h"

#include <algorithm>

namespace Drydock::Hlsl
{

namespace
{

constexpr std::string_view SignatureClasses = "nrdiaxyejk";
constexpr std::string_view SignatureMethodLetters = "clgopEVzZNBM";

bool IsSignatureClass(char Letter)
{
	return SignatureClasses.find(Letter) != std::string_view::npos;
}

/** The words for a class in a message. */
const char* GetSignatureClassWords(char Class)
{
	switch (Class)
	{
	case 'i':
	case 'j':
		return "an integer";
	case 'k':
		return "an integer of 64 bits (int64_t, uint64_t)";
	case 'x':
		return "a number of 32 bits (float, int, uint)";
	case 'y':
		return "a number of 16 bits (float16_t, int16_t, uint16_t)";
	case 'e':
		return "a float or an integer of 32 or 64 bits";
	default:
		return "a number";
	}
}

EScalar GetSignatureScalar(const FTypes& Types, char Letter)
{
	switch (Letter == 'h' && Types.HasRealHalf() ? 'H' : Letter)
	{
	case 'h':
		return EScalar::MinFloat;
	case 'H':
	case 'y':
		return EScalar::Half;
	case 's':
		return EScalar::Int;
	case 'u':
	case 'i':
	case 'j':
	case 'e':
		return EScalar::Uint;
	case 'k':
		return EScalar::Ulong;
	case 'b':
		return EScalar::Bool;
	case 'D':
		return EScalar::Double;
	case 'S':
		return EScalar::Short;
	case 'W':
		return EScalar::Ushort;
	default:
		return EScalar::Float;
	}
}

bool IsSignatureShort(char Letter)
{
	return Letter == 'S' || Letter == 'W';
}

/** A row or a column as a vector, which it becomes by itself. */
const FType* GetSignatureVector(FTypes& Types, const FType* Type)
{
	const bool bThin = Type->IsMatrix() && (Type->Rows == 1 || Type->Columns == 1);
	return bThin ? Types.Vector(Type->Scalar, Type->NumComponents()) : Type;
}

std::string CountSignatureArguments(size_t Count)
{
	return std::to_string(Count) + (Count == 1 ? " argument" : " arguments");
}

/** One signature against one call. */
class FSignatureMatch
{
public:
	FSignatureMatch(FTypes& InTypes, std::string_view InName, const FSignature& InSignature,
		const std::vector<const FType*>& InArguments, const FMethodContext* InMethod)
		: Types(InTypes)
		, Name(InName)
		, Signature(InSignature)
		, Arguments(InArguments)
		, Method(InMethod)
	{
	}

	size_t GetMaximum() const { return Signature.Parameters.size(); }
	size_t GetMinimum() const
	{
		const auto First = std::ranges::find(Signature.Parameters, true, &FPattern::bOptional);
		return size_t(First - Signature.Parameters.begin());
	}
	/** How many arguments there are too few or too many. */
	size_t GetMissing() const
	{
		const size_t Count = Arguments.size();
		return Count < GetMinimum() ? GetMinimum() - Count : Count > GetMaximum() ? Count - GetMaximum() : 0;
	}

	/** False with Error where it does not fit. */
	bool Run()
	{
		CheckKinds();
		FindGroup();
		FindShape();
		for (size_t i = 0; i < Arguments.size() && Error.empty(); ++i)
		{
			CheckArgument(i);
		}
		return Error.empty();
	}

	FIntrinsicCall MakeCall() const
	{
		FIntrinsicCall Call;
		Call.Name = Name;
		Call.Result = Signature.Result.IsVoid() ? Types.Void() : Make(Signature.Result, Matrix);
		for (size_t i = 0; i < Arguments.size(); ++i)
		{
			const FPattern& Pattern = Signature.Parameters[i];
			Call.Parameters.push_back(Pattern.bPlace ? Arguments[i] : Make(Pattern, Arguments[i]));
			Call.bOut.push_back(Pattern.bOut || Pattern.bPlace);
		}
		return Call;
	}

	/** "lerp(float3, float3, float3)": as it can be written, for what is known of the arguments. */
	std::string GetForm()
	{
		const std::string Before = Error;
		FindGroup();
		FindShape();
		Error = Before;
		const size_t Count = std::clamp(Arguments.size(), GetMinimum(), GetMaximum());
		std::string Form = std::string(Name) + "(";
		for (size_t i = 0; i < Count; ++i)
		{
			const FPattern& Pattern = Signature.Parameters[i];
			const FType* const Argument = i < Arguments.size() && Arguments[i]->IsNumeric() ? Arguments[i] : nullptr;
			const FType* const Type = Make(Pattern, Argument);
			Form += (i ? ", " : "") + std::string(Pattern.bOut ? "out " : Pattern.bPlace ? "inout " : "");
			Form += Pattern.Scalar == 'z'   ? "SamplerState"
					: Pattern.Scalar == 'Z' ? "SamplerComparisonState"
											: GetName(Type);
		}
		return Form + ")";
	}

	std::string Error;

private:
	/** The first error holds. */
	void Expect(size_t Index, const std::string& What)
	{
		if (Error.empty())
		{
			Error = "X3013: argument " + std::to_string(Index + 1) + " of '" + std::string(Name) + "' has the type " +
					GetName(Arguments[Index]) + ", but " + What + " is expected";
		}
	}

	size_t GetCount() const { return std::min(Arguments.size(), GetMaximum()); }

	void CheckKinds()
	{
		for (size_t i = 0; i < GetCount(); ++i)
		{
			const FPattern& Pattern = Signature.Parameters[i];
			const FType* const Type = Arguments[i];
			const bool bSampler = Type->IsObject() && Type->Object == EObject::SamplerState;
			const bool bComparing = Type->IsObject() && Type->Object == EObject::SamplerComparisonState;
			if (Pattern.Scalar == 'z' || Pattern.Scalar == 'Z')
			{
				if (Pattern.Scalar == 'z' ? !bSampler : !bComparing)
				{
					Expect(i, Pattern.Scalar == 'z' ? "a SamplerState" : "a SamplerComparisonState");
				}
			}
			else if (Pattern.Scalar == 'B' || Pattern.Scalar == 'M' || Pattern.Scalar == 'E')
			{
				if (HasObject(Type) || Type->Kind == EType::Void || Type->Kind == EType::String)
				{
					Expect(i, "a type that lies in memory");
				}
			}
			else if (!Type->IsNumeric())
			{
				Expect(i, "a number");
			}
		}
	}

	/** The scalar in which all of a class meet. */
	void FindGroup()
	{
		std::optional<EScalar> Met;
		char Class = 0;
		bool bPlace = false;
		for (size_t i = 0; i < GetCount() && !bPlace; ++i)
		{
			const FPattern& Pattern = Signature.Parameters[i];
			if (!IsSignatureClass(Pattern.Scalar) || Pattern.bOut || !Arguments[i]->IsNumeric())
			{
				continue;
			}
			Class = Pattern.Scalar;
			bPlace = Pattern.bPlace; // its scalar is that of memory
			const EScalar Scalar = Arguments[i]->Scalar;
			Met = Met && *Met != Scalar ? MeetScalars(*Met, Scalar) : Scalar; // two bools meet in bool here
			if (!FitScalar(Types, Class, Scalar))
			{
				Expect(i, GetSignatureClassWords(Class));
			}
		}
		const std::optional<EScalar> Fitting = Met ? FitScalar(Types, Class, *Met) : std::nullopt;
		if (Met && !Fitting)
		{
			Expect(0, GetSignatureClassWords(Class)); // each fits, but not what they meet in
		}
		Group = Fitting;
	}

	/** The shape in which all with a * or v meet. */
	void FindShape()
	{
		Shape = nullptr;
		Matrix = nullptr;
		for (size_t i = 0; i < GetCount(); ++i)
		{
			const FPattern& Pattern = Signature.Parameters[i];
			if (!Arguments[i]->IsNumeric() || Pattern.bOut)
			{
				continue;
			}
			const FType* const Type = Pattern.Shape == 'v' ? GetSignatureVector(Types, Arguments[i]) : Arguments[i];
			if (Pattern.Shape == 'm' || Pattern.Shape == 'q')
			{
				Matrix = Type;
				if (!Type->IsMatrix() || (Pattern.Shape == 'q' && Type->Rows != Type->Columns))
				{
					Expect(i, Pattern.Shape == 'q' ? "a square matrix" : "a matrix");
				}
			}
			else if (Pattern.Shape == 'v' && Type->IsMatrix())
			{
				Expect(i, "a scalar or a vector");
			}
			else if (Pattern.Shape == '*' || Pattern.Shape == 'v')
			{
				Meet(Type);
			}
		}
	}

	void Meet(const FType* Type)
	{
		bool bTruncates = false;
		std::string Why;
		const FType* const Met = Shape ? MeetTypes(Types, Shape, Type, bTruncates, Why) : Type;
		if (Met && Met->IsNumeric())
		{
			Shape = Met;
		}
		else if (Error.empty())
		{
			Error = "X3013: the arguments of '" + std::string(Name) + "' do not fit each other: " + Why;
		}
	}

	void CheckArgument(size_t Index)
	{
		const FPattern& Pattern = Signature.Parameters[Index];
		const FType* const Type = Arguments[Index];
		const FType* const Parameter = Make(Pattern, Type);
		if (IsSignatureShort(Pattern.Scalar) && Types.GetBits(Type->Scalar) != 16)
		{
			Expect(Index, GetName(Parameter));
		}
		else if (Pattern.bPlace)
		{
			const bool bAtomic =
				(Type->Scalar >= EScalar::Int && Type->Scalar <= EScalar::Ulong) || Type->Scalar == EScalar::Float;
			const bool bFits = Type->IsScalar() && bAtomic && Type->Scalar == Parameter->Scalar;
			if (!bFits)
			{
				Expect(Index, Pattern.Scalar == 'f'   ? "a place of float"
							  : Pattern.Scalar == 'e' ? "a place of int, uint, int64_t, uint64_t or float"
													  : "a place of int, uint, int64_t or uint64_t");
			}
		}
		else if (Pattern.bOut)
		{
			// The places of results may have another type: what is written is converted then. modf has a form for
			// integers.
			const bool bInteger = !IsReal(Type->Scalar);
			if ((Pattern.Scalar == 's' && !bInteger) || !FindConversion(Types, Parameter, Type).bPossible)
			{
				Expect(Index, "a place of " + GetName(Parameter));
			}
		}
		else if (Parameter != Type && !FindConversion(Types, Type, Parameter).bPossible)
		{
			Expect(Index, GetName(Parameter));
		}
	}

	/** The type of a parameter or of the result. */
	const FType* Make(const FPattern& Pattern, const FType* Argument) const
	{
		if (SignatureMethodLetters.find(Pattern.Scalar) != std::string_view::npos && Method)
		{
			return MakeMethodType(Types, Pattern.Scalar, *Method, Argument);
		}
		const bool bGroup = IsSignatureClass(Pattern.Scalar) && Group;
		const EScalar Scalar = bGroup ? *Group : GetSignatureScalar(Types, Pattern.Scalar);
		switch (Pattern.Shape)
		{
		case 0:
			return Types.Scalar(Scalar);
		case '*':
		case 'v':
		{
			const bool bOwn = Argument && Shape && Argument->IsMatrix() && Shape->IsMatrix() &&
							  Argument->Rows == Shape->Rows && Argument->Columns == Shape->Columns;
			return bOwn ? Types.Matrix(
							  Scalar, Shape->Rows, Shape->Columns, Argument->Order) // no turning of rows and columns
				   : Shape ? Types.Numeric(Scalar, Shape->Shape, Shape->Rows, Shape->Columns, Shape->Order)
						   : Types.Scalar(Scalar);
		}
		case 'm':
		case 'q':
		case 't':
		{
			const bool bMatrix =
				Argument && Argument->IsMatrix() && (Pattern.Shape != 'q' || Argument->Rows == Argument->Columns);
			return !bMatrix               ? Types.Matrix(Scalar, 3, 3)
				   : Pattern.Shape == 't' ? Types.Matrix(Scalar, Argument->Columns, Argument->Rows, Argument->Order)
										  : Types.Matrix(Scalar, Argument->Rows, Argument->Columns, Argument->Order);
		}
		default:
			return Types.Vector(Scalar, uint32_t(Pattern.Shape - '0'));
		}
	}

	FTypes& Types;
	const std::string_view Name;
	const FSignature& Signature;
	const std::vector<const FType*>& Arguments;
	const FMethodContext* const Method;
	std::optional<EScalar> Group;
	const FType* Shape = nullptr;
	const FType* Matrix = nullptr;
};

/** "'lerp' takes 3 arguments, but 2 are given". Matches: all forms, none of which has this many. */
std::string CountSignatureError(
	std::string_view Name, const std::vector<FSignatureMatch>& Matches, const FSignatureMatch& Nearest, size_t Given)
{
	std::vector<size_t> Counts;
	for (const FSignatureMatch& Match : Matches)
	{
		for (size_t Count = Match.GetMinimum(); Count <= Match.GetMaximum(); ++Count)
		{
			Counts.push_back(Count);
		}
	}
	std::ranges::sort(Counts);
	Counts.erase(std::unique(Counts.begin(), Counts.end()), Counts.end());
	std::string Taken;
	for (size_t i = 0; i + 1 < Counts.size(); ++i)
	{
		Taken += std::to_string(Counts[i]) + (i + 2 < Counts.size() ? ", " : " or ");
	}
	FSignatureMatch Form = Nearest;
	return "X3013: '" + std::string(Name) + "' takes " + Taken + CountSignatureArguments(Counts.back()) + ", but " +
		   (Given == 0 ? std::string("none is") : std::to_string(Given) + (Given == 1 ? " is" : " are")) +
		   " given; write " + Form.GetForm();
}

} // namespace

bool HasErrorType(const std::vector<const FType*>& Arguments)
{
	return std::ranges::any_of(Arguments, [](const FType* Type) { return Type && Type->Kind == EType::Error; });
}

std::optional<EScalar> FitScalar(const FTypes& Types, char Class, EScalar Scalar)
{
	const EScalar Number = Scalar == EScalar::Bool || Scalar == EScalar::LiteralInt ? EScalar::Int
						   : Scalar == EScalar::LiteralFloat                        ? EScalar::Float
																					: Scalar;
	const bool bWide = Types.GetBits(Number) == 64;
	const auto If = [](bool bFits, EScalar Fitting)
	{
		return bFits ? std::optional(Fitting) : std::nullopt;
	};
	switch (Class)
	{
	case 'a':
		return Scalar == EScalar::Bool ? Scalar : Number;
	case 'r':
		return IsReal(Number) && !bWide ? Number : EScalar::Float;
	case 'd':
		return IsReal(Number) ? Number : EScalar::Float;
	case 'i':
		return If(IsInteger(Number), Number);
	case 'j': // a literal is the uint of memory
		return If(!bWide,
			Scalar == EScalar::LiteralInt || IsUnsigned(Number) || IsReal(Number) ? EScalar::Uint : EScalar::Int);
	case 'k':
		return If(IsInteger(Number), Scalar == EScalar::Long ? EScalar::Long : EScalar::Ulong);
	case 'x':
		return If(Types.GetBits(Number) == 32, IsReal(Number)       ? EScalar::Float
											   : IsUnsigned(Number) ? EScalar::Uint
																	: EScalar::Int);
	case 'y':
		return If(Types.GetBits(Number) == 16, IsReal(Number)       ? EScalar::Half
											   : IsUnsigned(Number) ? EScalar::Ushort
																	: EScalar::Short);
	case 'e':
		return If((IsInteger(Number) && Types.GetBits(Number) >= 32) || Number == EScalar::Float, Number);
	default:
		return Number;
	}
}

FIntrinsicCall ChooseSignature(FTypes& Types, std::string_view Name, std::span<const FSignature> Signatures,
	const std::vector<const FType*>& Arguments, const FMethodContext* Method)
{
	FIntrinsicCall Call;
	Call.Name = Name;
	if (HasErrorType(Arguments))
	{
		Call.Result = Types.Error();
		Call.Parameters = Arguments;
		Call.bOut.assign(Arguments.size(), false);
		return Call;
	}
	std::vector<FSignatureMatch> Matches;
	for (const FSignature& Signature : Signatures)
	{
		Matches.emplace_back(Types, Name, Signature, Arguments, Method);
		FSignatureMatch& Match = Matches.back();
		if (Match.GetMissing() == 0)
		{
			if (Match.Run())
			{
				return Match.MakeCall();
			}
			Call.Error = Match.Error + "; write " + Match.GetForm();
		}
	}
	if (Call.Error.empty())
	{
		const FSignatureMatch& Nearest = *std::ranges::min_element(Matches, {}, &FSignatureMatch::GetMissing);
		Call.Error = CountSignatureError(Name, Matches, Nearest, Arguments.size());
	}
	return Call;
}

} // namespace Drydock::Hlsl
