// Deduces a template's arguments: the pattern of a parameter against the type of what is given.
#include "HlslAnalysisImpl.h"

#include <algorithm>

namespace Drydock::Hlsl
{

namespace
{

/** Which parameter a name is; Template.size() where it is none. */
size_t FindTemplateParameter(const FDeclaration& Template, const FName& Name)
{
	size_t Index = 0;
	const bool bPlain = Name.Parts.size() == 1 && !Name.Parts[0].bArguments && !Name.bGlobal;
	while (Index < Template.Template.size() && !(bPlain && Template.Template[Index].Name == Name.Parts[0].Text))
	{
		++Index;
	}
	return Index;
}

} // namespace

std::string NameTemplateArguments(const std::vector<FTemplateValue>& Values)
{
	std::string Result;
	for (const FTemplateValue& Value : Values)
	{
		Result += Result.empty() ? "<" : ", ";
		if (!Value.Value)
		{
			Result += GetName(Value.Type);
			continue;
		}
		const uint64_t Bits = Value.Value->Constant.empty() ? 0 : Value.Value->Constant[0];
		const EScalar Scalar = Value.Type->Scalar;
		Result += Scalar == EScalar::Bool   ? (Bits ? "true" : "false")
				  : IsUnsigned(Scalar)      ? std::to_string(Bits)
				  : Scalar == EScalar::Long ? std::to_string(int64_t(Bits))
											: std::to_string(int32_t(uint32_t(Bits)));
	}
	return Result + ">";
}

bool FAnalyser::DeduceValue(size_t Index, FTemplateValue Value, FDeduction& Into)
{
	if (Value.Type->IsNumeric() && IsLiteral(Value.Type->Scalar))
	{
		const bool bInt = Value.Type->Scalar == EScalar::LiteralInt;
		Value.Type = Types->WithScalar(Value.Type, bInt ? EScalar::Int : EScalar::Float);
	}
	const FTemplateParameter& Parameter = Into.Template->Template[Index];
	if (Value.Value && Parameter.ValueType)
	{
		Value.Type = Value.Value->Type;
	}
	std::optional<FTemplateValue>& Known = Into.Values[Index];
	const bool bEqual = Known && (Value.Value ? Known->Value && Known->Value->Constant == Value.Value->Constant
											  : IsSame(Known->Type, Value.Type));
	if (Known && !bEqual && Index >= Into.NumGiven)
	{
		Into.Why = "'" + std::string(Parameter.Name) + "' would be " + NameTemplateArguments({*Known}) + " and " +
				   NameTemplateArguments({Value});
		return false;
	}
	if (!Value.Value != !Parameter.ValueType)
	{
		return false;
	}
	Known = Known ? Known : Value;
	return true;
}

/** A parameter's pattern against an argument. A pattern that does not depend on the template fits here. */
bool FAnalyser::Deduce(
	const FTypeName& Pattern, const std::vector<FExpression*>& Dimensions, const FType* Type, FDeduction& Into)
{
	for (const FExpression* Dimension : Dimensions)
	{
		if (!Type->IsArray())
		{
			return false;
		}
		const bool bName = Dimension && Dimension->Kind == EExpression::Name;
		const size_t Index = bName ? FindTemplateParameter(*Into.Template, Dimension->Name) : Into.Values.size();
		if (Index < Into.Values.size())
		{
			const FType* const Int = Types->Scalar(EScalar::Int);
			if (!DeduceValue(Index, {Int, MakeConstant(Int, {Type->Count}, Dimension->Place)}, Into))
			{
				return false;
			}
		}
		Type = Type->Element;
	}
	if (Pattern.Name.Parts.empty())
	{
		return true;
	}
	const size_t Index = FindTemplateParameter(*Into.Template, Pattern.Name);
	if (Index < Into.Values.size())
	{
		return DeduceValue(Index, {Type, nullptr}, Into);
	}
	return !Pattern.Name.Parts.back().bArguments || DeducePart(Pattern.Name.Parts.back(), Type, Into);
}

/** `vector<T, N>`, `Texture2D<T>`, `FPair<T, U>`. */
bool FAnalyser::DeducePart(const FNamePart& Part, const FType* Type, FDeduction& Into)
{
	std::vector<FTemplateValue> Values;
	const FType* const Int = Types->Scalar(EScalar::Int);
	const auto AddNumber = [&](uint32_t Number)
	{
		Values.push_back({Int, MakeConstant(Int, {Number}, Part.Place)});
	};
	if (Part.Text == "vector" && Type->IsNumeric() && !Type->IsMatrix())
	{
		Values.push_back({Types->Scalar(Type->Scalar), nullptr});
		AddNumber(Type->Columns);
	}
	else if (Part.Text == "matrix" && Type->IsMatrix())
	{
		Values.push_back({Types->Scalar(Type->Scalar), nullptr});
		AddNumber(Type->Rows);
		AddNumber(Type->Columns);
	}
	else if (Type->IsObject() && Type->ObjectName == Part.Text && Type->Element)
	{
		Values.push_back({Type->Element, nullptr});
	}
	else if (Type->IsStruct())
	{
		const FStructInfo* Info = GetInfo(Type);
		while (Info && (!Info->Template || Info->Template->Name != Part.Text))
		{
			Info = Info->Base;
		}
		Values = Info ? Info->Arguments : Values;
	}
	if (Values.size() < Part.Arguments.size() || Values.empty())
	{
		return false;
	}
	for (size_t i = 0; i < Part.Arguments.size(); ++i)
	{
		if (!DeduceArgument(Part.Arguments[i], Values[i], Into))
		{
			return false;
		}
	}
	return true;
}

/** An argument's pattern against what stands there; one that does not depend on the template must be the same. */
bool FAnalyser::DeduceArgument(const FTemplateArgument& Pattern, const FTemplateValue& Value, FDeduction& Into)
{
	const bool bName = Pattern.Value && Pattern.Value->Kind == EExpression::Name;
	const FName* const Name = Pattern.Type ? &Pattern.Type->Name : bName ? &Pattern.Value->Name : nullptr;
	const bool bPlain = Name && !Name->Parts.empty() && (!Pattern.Type || Pattern.Type->Dimensions.empty());
	const size_t Index = bPlain ? FindTemplateParameter(*Into.Template, *Name) : Into.Values.size();
	if (Index < Into.Values.size())
	{
		return DeduceValue(Index, Value, Into);
	}
	if (Value.Value)
	{
		const std::optional<int64_t> Number =
			Pattern.Value ? FindInteger(*Pattern.Value, "the template's argument") : std::nullopt;
		return Number && !Value.Value->Constant.empty() && uint32_t(*Number) == uint32_t(Value.Value->Constant[0]);
	}
	if (bPlain && Name->Parts.back().bArguments && DeducePart(Name->Parts.back(), Value.Type, Into))
	{
		return true;
	}
	FTemplateParameter Any;
	const std::optional<FTemplateValue> Found = ReadArgument(Pattern, Any);
	return Found && IsSame(Found->Type, Value.Type);
}

} // namespace Drydock::Hlsl
