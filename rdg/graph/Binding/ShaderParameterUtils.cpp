// Sets constants and resources of a bound shader by their names.
#include "ShaderBinding.h"
#include "ShaderCompilation.h"
#include "ShaderParameterUtils.h"

#include <algorithm>
#include <cstring>

namespace Drydock
{

namespace
{

constexpr const char* LooseConstants = "$Global"; // of the reflection

/** All that has to be set before the shader runs; constants have 0. */
std::vector<std::string> ListToBeSet(const FShaderReflection& Reflection)
{
	std::vector<std::string> Names;
	for (const FShaderConstant& Constant : Reflection.Constants)
	{
		if (Constant.bUsed && Reflection.ConstantBuffers[Constant.Buffer].Name != LooseConstants)
		{
			Names.push_back(Constant.Name);
		}
	}
	for (const auto* Resources : {&Reflection.Textures, &Reflection.RWTextures, &Reflection.Samplers,
			 &Reflection.Buffers, &Reflection.RWBuffers})
	{
		for (const FShaderResource& Resource : *Resources)
		{
			Names.push_back(Resource.Name);
		}
	}
	return Names;
}

/** Makes Bound one of the parameter's shader. */
void Begin(FBoundShader& Bound, const FShaderResourceParameter& Parameter)
{
	FShader* const Shader = Parameter.FindShader();
	checkf(Shader, TEXT("a parameter is set that was not bound: call Bind in the constructor of the shader class"));
	if (!Bound.IsValid() || Bound.Permutation != Shader)
	{
		Bound = BindToBeSet(*Shader);
		Bound.Unset = ListToBeSet(Bound.GetReflection());
	}
	std::erase(Bound.Unset, Parameter.GetName());
}

/** Puts a resource into the slot of that name, if the shader has one. */
template<typename TView, typename TGet>
void Put(const std::vector<FShaderResource>& Names, std::vector<TView>& Slots, const std::string& Name, const TGet& Get,
	std::vector<FRHITexture*>* Owners = nullptr, FRHITexture* Owner = nullptr)
{
	const auto Found = std::ranges::find(Names, Name, &FShaderResource::Name);
	if (Found != Names.end())
	{
		Slots[size_t(Found - Names.begin())] = Get();
		if (Owners)
		{
			(*Owners)[size_t(Found - Names.begin())] = Owner;
		}
	}
}

/** Bytes of a constant. */
size_t GetSize(const FShaderConstant& Constant)
{
	const int32 NumVectors = Constant.bRowMajor ? Constant.Rows : Constant.Columns;
	const size_t Element =
		Constant.Rows > 1 ? size_t(NumVectors) * Constant.MatrixStride : size_t(Constant.Columns) * sizeof(float);
	return Constant.NumElements ? size_t(Constant.NumElements - 1) * Constant.ArrayStride + Element : Element;
}

template<typename TView>
void SetView(FBoundShader& Bound, const FShaderResourceParameter& Parameter, TView* View, bool bWritten)
{
	if (!View)
	{
		return;
	}
	Begin(Bound, Parameter);
	const FShaderReflection& Reflection = Bound.GetReflection();
	Put(
		bWritten ? Reflection.RWTextures : Reflection.Textures, bWritten ? Bound.RWTextures : Bound.Textures,
		Parameter.GetName(), [View] { return View->GetKernelTexture(); },
		bWritten ? &Bound.RWTextureOwners : &Bound.TextureOwners, View->GetTexture());
	Put(bWritten ? Reflection.RWBuffers : Reflection.Buffers, bWritten ? Bound.RWBuffers : Bound.Buffers,
		Parameter.GetName(), [View] { return View->GetKernelBuffer(); });
}

} // namespace

void SetNamedValue(
	FBoundShader& Bound, const FShaderResourceParameter& Parameter, const void* Value, uint32 NumBytes, uint32 Element)
{
	Begin(Bound, Parameter);
	const std::vector<FShaderConstant>& Constants = Bound.GetReflection().Constants;
	const auto Found = std::ranges::find(Constants, Parameter.GetName(), &FShaderConstant::Name);
	if (Found == Constants.end())
	{
		return; // the shader does not read it
	}
	constexpr uint32 Register = 16;
	std::vector<uint8>& Data = Bound.ConstantData[Found->Buffer];
	const size_t Begin = size_t(Element) * ((NumBytes + Register - 1) / Register * Register);
	const size_t Size = GetSize(*Found);
	for (size_t Byte = 0; Byte < NumBytes && Begin + Byte < Size; Byte += sizeof(float))
	{
		// C++ has matrices row by row.
		const size_t Scalar = Byte / sizeof(float);
		const size_t Place =
			Found->Rows > 1 && !Found->bRowMajor ? Scalar / 4 * sizeof(float) + Scalar % 4 * Found->MatrixStride : Byte;
		std::memcpy(
			Data.data() + Found->Offset + Begin + Place, static_cast<const uint8*>(Value) + Byte, sizeof(float));
	}
}

void SetNamedTexture(FBoundShader& Bound, const FShaderResourceParameter& Parameter, FRHITexture* Texture)
{
	if (Texture)
	{
		Begin(Bound, Parameter);
		Put(
			Bound.GetReflection().Textures, Bound.Textures, Parameter.GetName(),
			[Texture] { return Texture->GetKernelView(); }, &Bound.TextureOwners, Texture);
	}
}

void SetNamedSampler(FBoundShader& Bound, const FShaderResourceParameter& Parameter, FRHISamplerState* Sampler)
{
	if (Sampler)
	{
		Begin(Bound, Parameter);
		Put(Bound.GetReflection().Samplers, Bound.Samplers, Parameter.GetName(),
			[Sampler] { return Sampler->GetKernelSampler(); });
	}
}

void SetNamedView(FBoundShader& Bound, const FShaderResourceParameter& Parameter, FRHIShaderResourceView* View)
{
	SetView(Bound, Parameter, View, false);
}

void SetNamedView(FBoundShader& Bound, const FShaderResourceParameter& Parameter, FRHIUnorderedAccessView* View)
{
	SetView(Bound, Parameter, View, true);
}

} // namespace Drydock

bool FShaderResourceParameter::IsBound() const
{
	FShader* const Shader = FindShader();
	if (!Shader)
	{
		return false;
	}
	const std::shared_ptr<const Drydock::FShaderReflection> Reflection =
		Drydock::GetShaderReflection(Drydock::FShaderRef(Shader));
	const auto IsIn = [this](const auto& Named)
	{
		return std::ranges::any_of(Named, [this](const auto& Each) { return Each.Name == Name; });
	};
	return IsIn(Reflection->Constants) || IsIn(Reflection->Textures) || IsIn(Reflection->RWTextures) ||
		   IsIn(Reflection->Samplers) || IsIn(Reflection->Buffers) || IsIn(Reflection->RWBuffers);
}
