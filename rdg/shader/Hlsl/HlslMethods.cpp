// Methods of HLSL's resources: which there are, and what a call of one comes to.
#include "HlslIntrinsics.h"

#include "Diagnostics.h"
#include "HlslIntrinsicTable.h"

#include <algorithm>

namespace Drydock::Hlsl
{

namespace
{

bool IsMethodCube(EObject Object)
{
	return Object == EObject::TextureCube || Object == EObject::TextureCubeArray;
}

bool IsMethodArray(EObject Object)
{
	switch (Object)
	{
	case EObject::Texture1DArray:
	case EObject::Texture2DArray:
	case EObject::Texture2DMSArray:
	case EObject::TextureCubeArray:
	case EObject::RWTexture1DArray:
	case EObject::RWTexture2DArray:
		return true;
	default:
		return false;
	}
}

bool HasMethodMips(EObject Object)
{
	const bool bMultisampled = Object == EObject::Texture2DMS || Object == EObject::Texture2DMSArray;
	return IsTexture(Object) && !IsWritable(Object) && !bMultisampled;
}

const FType* MakeMethodVector(FTypes& Types, EScalar Scalar, uint32_t Count)
{
	return Count > 1 ? Types.Vector(Scalar, Count) : Types.Scalar(Scalar);
}

/** The type that a read of the resource gives. */
const FType* GetMethodElement(FTypes& Types, const FType* Object)
{
	const FType* const Element = Object->Element ? Object->Element : Types.Vector(EScalar::Float, 4);
	return Element->bUnorm || Element->bSnorm ? Types.WithNorm(Element, false, false) : Element;
}

/** A value as it lies in memory. */
const FType* GetMethodStored(FTypes& Types, const FType* Argument)
{
	if (!Argument)
	{
		return Types.Scalar(EScalar::Uint);
	}
	const EScalar Scalar = Argument->Scalar == EScalar::LiteralInt     ? EScalar::Uint
						   : Argument->Scalar == EScalar::LiteralFloat ? EScalar::Float
																	   : Argument->Scalar;
	return Argument->IsNumeric() && Scalar != Argument->Scalar ? Types.WithScalar(Argument, Scalar) : Argument;
}

bool IsMethodOf(const FMethodRow& Row, EObject Object)
{
	return (Row.Objects >> uint32_t(Object) & 1) != 0;
}

/** The name as the row has it; empty: it has none such. */
std::string_view FindMethodName(const FMethodRow& Row, std::string_view Name)
{
	std::string_view Names = Row.Names;
	std::string_view Found = TakeName(Names);
	while (!Found.empty() && Found != Name)
	{
		Found = TakeName(Names);
	}
	return Found;
}

/** An object of another kind that has this method, for the message that this one lacks it. */
std::string ListMethodOwners(std::string_view Name)
{
	static constexpr const char* Owners[] = {"Texture1D", "Texture1DArray", "Texture2D", "Texture2DArray",
		"Texture2DMS", "Texture2DMSArray", "Texture3D", "TextureCube", "TextureCubeArray", "RWTexture1D",
		"RWTexture1DArray", "RWTexture2D", "RWTexture2DArray", "RWTexture3D", "Buffer", "RWBuffer", "StructuredBuffer",
		"RWStructuredBuffer", "AppendStructuredBuffer", "ConsumeStructuredBuffer", "ByteAddressBuffer",
		"RWByteAddressBuffer"};
	std::string List;
	for (size_t i = 0; i < std::size(Owners); ++i)
	{
		const bool bOwner = std::ranges::any_of(GetMethodRows(),
			[&](const FMethodRow& Row) { return IsMethodOf(Row, EObject(i)) && !FindMethodName(Row, Name).empty(); });
		List += bOwner ? (List.empty() ? "" : ", ") + std::string(Owners[i]) : std::string();
	}
	return List;
}

bool IsMethodTemplate(const FSignature& Signature)
{
	const auto IsType = [](const FPattern& Pattern)
	{
		return Pattern.Scalar == 'B';
	};
	return IsType(Signature.Result) || std::ranges::any_of(Signature.Parameters, IsType);
}

std::string CheckMethodTemplate(std::string_view Name, const std::vector<const FType*>& Arguments, bool bKnown)
{
	const std::string Quoted = "'" + std::string(Name) + "'";
	if (!bKnown)
	{
		return "X3013: " + Quoted + " takes no type between < and >";
	}
	if (Arguments.size() != 1)
	{
		return "X3013: " + Quoted + " takes one type between < and >; write " + std::string(Name) + "<float4>(...)";
	}
	const FType* const Type = Arguments[0];
	const bool bMemory = Type && (Type->IsNumeric() || Type->IsStruct() || Type->IsArray()) && !HasObject(Type);
	return bMemory ? std::string()
				   : "X3013: " + Quoted + " reads and writes types that lie in memory, not " + GetName(Type);
}

} // namespace

uint32_t GetDimensions(EObject Object)
{
	uint32_t Count = IsMethodArray(Object) ? 1 : 0;
	switch (Object)
	{
	case EObject::Texture2D:
	case EObject::Texture2DArray:
	case EObject::Texture2DMS:
	case EObject::Texture2DMSArray:
	case EObject::RWTexture2D:
	case EObject::RWTexture2DArray:
		return Count + 2;
	case EObject::Texture3D:
	case EObject::TextureCube:
	case EObject::TextureCubeArray:
	case EObject::RWTexture3D:
		return Count + 3;
	case EObject::ConstantBuffer:
	case EObject::TextureBuffer:
	case EObject::SamplerState:
	case EObject::SamplerComparisonState:
	case EObject::Unsupported:
		return 0;
	default:
		return Count + 1;
	}
}

const FType* MakeMethodType(FTypes& Types, char Letter, const FMethodContext& Method, const FType* Argument)
{
	const EObject Object = Method.Object->Object;
	const uint32_t NumCoordinates = GetDimensions(Object);
	const uint32_t NumDimensions = NumCoordinates - (IsMethodArray(Object) ? 1 : 0);
	switch (Letter)
	{
	case 'c':
		return MakeMethodVector(Types, EScalar::Float, NumCoordinates);
	case 'l':
	case 'g':
		return MakeMethodVector(Types, EScalar::Float, NumDimensions);
	case 'o':
		return MakeMethodVector(Types, EScalar::Int, NumDimensions);
	case 'p':
		return MakeMethodVector(Types, EScalar::Int, NumCoordinates + (HasMethodMips(Object) ? 1 : 0));
	case 'E':
		return GetMethodElement(Types, Method.Object);
	case 'V':
		return Types.Vector(GetMethodElement(Types, Method.Object)->Scalar, 4);
	case 'N':
	{
		const bool bAsked = Argument && (Argument->Scalar == EScalar::Int || Argument->Scalar == EScalar::Float);
		return Types.Scalar(bAsked ? Argument->Scalar : EScalar::Uint);
	}
	case 'B':
		return Method.Template;
	case 'M':
		return GetMethodStored(Types, Argument);
	default: // samplers
		return Argument;
	}
}

std::vector<std::string> ListMethods(const FType* Object)
{
	std::vector<std::string> Methods;
	for (const FMethodRow& Row : GetMethodRows())
	{
		std::string_view Names = IsMethodOf(Row, Object->Object) ? Row.Names : std::string_view();
		for (std::string_view Name = TakeName(Names); !Name.empty(); Name = TakeName(Names))
		{
			if (std::ranges::find(Methods, Name) == Methods.end())
			{
				Methods.emplace_back(Name);
			}
		}
	}
	return Methods;
}

FIntrinsicCall FindMethodCall(FTypes& Types, const FType* Object, std::string_view Name,
	const std::vector<const FType*>& TemplateArguments, const std::vector<const FType*>& Arguments)
{
	FIntrinsicCall Call;
	std::vector<FSignature> Plain;
	std::vector<FSignature> Templates;
	for (const FMethodRow& Row : GetMethodRows())
	{
		const std::string_view Found = IsMethodOf(Row, Object->Object) ? FindMethodName(Row, Name) : std::string_view();
		if (Found.empty())
		{
			continue;
		}
		Call.Name = Found;
		FSignature Signature = ReadSignature(Row.Signature);
		if (IsMethodCube(Object->Object))
		{
			std::erase_if(Signature.Parameters, [](const FPattern& Pattern) { return Pattern.Scalar == 'o'; });
		}
		(IsMethodTemplate(Signature) ? Templates : Plain).push_back(std::move(Signature));
	}
	if (Call.Name.empty())
	{
		const std::string Owners = ListMethodOwners(Name);
		Call.Error = "X3018: " + GetName(Object) + " has no method '" + std::string(Name) + "'" +
					 (Owners.empty() ? SuggestName(std::string(Name), ListMethods(Object)) : ", which is of " + Owners);
		return Call;
	}
	if (HasErrorType(TemplateArguments))
	{
		Call.Result = Types.Error();
		Call.Parameters = Arguments;
		Call.bOut.assign(Arguments.size(), false);
		return Call;
	}
	if (!TemplateArguments.empty())
	{
		Call.Error = CheckMethodTemplate(Name, TemplateArguments, !Templates.empty());
		if (!Call.Error.empty())
		{
			return Call;
		}
	}
	const FMethodContext Method{Object, TemplateArguments.empty() ? nullptr : TemplateArguments[0]};
	return ChooseSignature(Types, Call.Name, TemplateArguments.empty() ? Plain : Templates, Arguments, &Method);
}

} // namespace Drydock::Hlsl
