// Writes the functions that read, write and call resources by number: a switch over those of a type.
#include "HlslResources.h"

#include "TextTools.h"

namespace Drydock
{

namespace
{

struct FSignature
{
	std::string Result;
	std::vector<std::string> Arguments; // types
};

/** "uint2" of an RWTexture2D, "uint" of buffers. */
std::string GetIndexType(const std::string& Type)
{
	const std::string Kind = Type.substr(0, Type.find('<'));
	return Kind.ends_with("3D") || Kind.ends_with("2DArray")   ? "uint3"
		   : Kind.ends_with("2D") || Kind.ends_with("1DArray") ? "uint2"
															   : "uint";
}

std::optional<FSignature> GetSignature(const std::string& Type, const std::string& Method)
{
	const std::string Element = GetHlslElementType(Type);
	if (Method == "Get")
	{
		return FSignature{Element, {GetIndexType(Type)}};
	}
	if (Method == "Set")
	{
		return FSignature{"void", {GetIndexType(Type), Element}};
	}
	if (Method == "Read") // a ConstantBuffer
	{
		return FSignature{Type.substr(15, Type.size() - 16), {}};
	}
	if (Method == "Append" || Method == "Consume")
	{
		return Method == "Append" ? FSignature{"void", {Element}} : FSignature{Element, {}};
	}
	if (Method == "IncrementCounter" || Method == "DecrementCounter")
	{
		return FSignature{"uint", {}};
	}
	const bool bBytes = Type.find("ByteAddressBuffer") != std::string::npos;
	const std::string Count = IsDigit(Method.back()) ? Method.substr(Method.size() - 1) : "";
	const std::string Verb = Method.substr(0, Method.size() - Count.size());
	if (bBytes && (Verb == "Load" || Verb == "Store"))
	{
		return Verb == "Load" ? FSignature{"uint" + Count, {"uint"}} : FSignature{"void", {"uint", "uint" + Count}};
	}
	if (Method == "Load" && !bBytes)
	{
		const std::string Index = GetIndexType(Type);
		const bool bMip = Type.starts_with("Texture");
		return FSignature{Element, {bMip ? Index == "uint" ? "int2" : Index == "uint2" ? "int3" : "int4" : Index}};
	}
	if (Method == "SampleLevel" && Type.starts_with("Texture2D") && !Type.starts_with("Texture2DArray"))
	{
		return FSignature{Element, {"SamplerState", "float2", "float"}};
	}
	return {};
}

std::string GetFunctionName(const std::string& Type, const std::string& Method)
{
	std::string Name = "Drydock" + Method + "_";
	for (const char c : Type)
	{
		Name += IsWordCharacter(c) ? std::string(1, c) : c == '>' ? "" : "_";
	}
	return Name;
}

std::string GetHead(const std::string& Type, const std::string& Method)
{
	const FSignature Signature = *GetSignature(Type, Method);
	std::string Head = Signature.Result + " " + GetFunctionName(Type, Method) + "(uint Number";
	for (size_t i = 0; i < Signature.Arguments.size(); ++i)
	{
		Head += ", " + Signature.Arguments[i] + " A" + std::to_string(i);
	}
	return Head + ")";
}

} // namespace

std::string FHlslResourceAccessors::Want(const std::string& Type, const std::string& Method)
{
	Wanted.emplace(Type, Method);
	return GetFunctionName(Type, Method);
}

std::string FHlslResourceAccessors::Call(const std::string& Type, const std::string& Method)
{
	return GetSignature(Type, Method) ? Want(Type, Method) : std::string();
}

std::string FHlslResourceAccessors::GetPrototypes() const
{
	std::string Words;
	for (const auto& [Type, Method] : Wanted)
	{
		Words += GetHead(Type, Method) + "; ";
	}
	return Words;
}

std::string FHlslResourceAccessors::GetFunctions(const FHlslResourceNumbers& Numbers) const
{
	std::string Words;
	for (const auto& [Type, Method] : Wanted)
	{
		const FSignature Signature = *GetSignature(Type, Method);
		const bool bVoid = Signature.Result == "void";
		Words += GetHead(Type, Method) + " { ";
		if (!bVoid)
		{
			Words += Signature.Result + " R; ";
		}
		Words += "switch (Number) { ";
		const std::vector<std::string>& Leaves = Numbers.GetLeaves(Type);
		for (size_t i = 0; i < Leaves.size(); ++i)
		{
			std::string Arguments;
			for (size_t k = 0; k < Signature.Arguments.size(); ++k)
			{
				Arguments += (k ? ", A" : "A") + std::to_string(k);
			}
			const std::string Value = Method == "Get"    ? Leaves[i] + "[A0]"
									  : Method == "Set"  ? Leaves[i] + "[A0] = A1"
									  : Method == "Read" ? Leaves[i]
														 : Leaves[i] + "." + Method + "(" + Arguments + ")";
			// The last one also for numbers that nothing has, so that R always has a value.
			Words += (i + 1 == Leaves.size() ? "default" : "case " + std::to_string(i)) + ": " + (bVoid ? "" : "R = ") +
					 Value + "; break; ";
		}
		Words += bVoid ? "} } " : "} return R; } ";
	}
	return Words;
}

} // namespace Drydock
