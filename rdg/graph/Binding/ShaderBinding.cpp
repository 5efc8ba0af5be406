// Follows a binding plan inside a pass.
#include "ShaderBinding.h"

#include "BoundContents.h"
#include "NativeKernels.h"
#include "RangeTools.h"
#include "RHIResources.h"
#include "RenderGraphReport.h"
#include "RenderGraphResources.h"
#include "ShaderBindingChecks.h"
#include "ShaderBindingPlan.h"
#include "ShaderCompilation.h"
#include "ShaderParameterMacros.h"
#include "ShaderState.h"
#include "VertexDraw.h"

#include <cstring>

namespace Drydock
{

namespace
{

FKernelTexture GetTexture(const FResourceCopy& Copy, const void* Contents, FRHITexture*& OutOwner)
{
	const auto Take = [&OutOwner](auto* View)
	{
		OutOwner = View->GetTexture();
		return View->GetKernelTexture();
	};
	const auto TakeWhole = [&OutOwner](FRHITexture* Texture)
	{
		OutOwner = Texture;
		return Texture->GetKernelView();
	};
	switch (Copy.BaseType)
	{
	case UBMT_TEXTURE:
		return TakeWhole(ReadPointer<FRHITexture>(Contents, Copy.SourceOffset));
	case UBMT_SRV:
		return Take(ReadPointer<FRHIShaderResourceView>(Contents, Copy.SourceOffset));
	case UBMT_UAV:
		return Take(ReadPointer<FRHIUnorderedAccessView>(Contents, Copy.SourceOffset));
	case UBMT_RDG_TEXTURE:
		return TakeWhole(ReadPointer<FRDGTexture>(Contents, Copy.SourceOffset)->GetRHI());
	case UBMT_RDG_TEXTURE_SRV:
		return Take(ReadPointer<FRDGTextureSRV>(Contents, Copy.SourceOffset)->GetRHI());
	case UBMT_RDG_TEXTURE_UAV:
		return Take(ReadPointer<FRDGTextureUAV>(Contents, Copy.SourceOffset)->GetRHI());
	default:
		checkNoEntry();
		return {};
	}
}

FKernelBuffer GetBuffer(const FResourceCopy& Copy, const void* Contents)
{
	switch (Copy.BaseType)
	{
	case UBMT_SRV:
		return ReadPointer<FRHIShaderResourceView>(Contents, Copy.SourceOffset)->GetKernelBuffer();
	case UBMT_UAV:
		return ReadPointer<FRHIUnorderedAccessView>(Contents, Copy.SourceOffset)->GetKernelBuffer();
	case UBMT_RDG_BUFFER_SRV:
		return ReadPointer<FRDGBufferSRV>(Contents, Copy.SourceOffset)->GetRHI()->GetKernelBuffer();
	case UBMT_RDG_BUFFER_UAV:
		return ReadPointer<FRDGBufferUAV>(Contents, Copy.SourceOffset)->GetRHI()->GetKernelBuffer();
	default:
		checkNoEntry();
		return {};
	}
}

std::shared_ptr<const FShaderBindingPlan> GetPlan(
	const FShaderRef& Shader, const FShaderReflection& Reflection, const FShaderParametersMetadata& Metadata)
{
	FShaderState& State = Shader->GetState();
	std::lock_guard Lock(State.Mutex);
	std::shared_ptr<const FShaderBindingPlan>& Plan = State.Plans[&Metadata];
	if (!Plan)
	{
		std::vector<FDiagnostic> Diagnostics;
		auto NewPlan = std::make_shared<FShaderBindingPlan>(
			MakeShaderBindingPlan(Shader.GetType()->GetName(), Reflection, Metadata, Diagnostics));
		for (FDiagnostic& Diagnostic : Diagnostics)
		{
			Diagnostic.Message += std::string(" (entry ") + Shader.GetType()->GetFunctionName() + ")";
			if (Diagnostic.Severity == ESeverity::Warning)
			{
				ReportRDGWarning(Diagnostic, true);
			}
		}
		std::erase_if(Diagnostics, [](const FDiagnostic& Each) { return Each.Severity == ESeverity::Warning; });
		if (!Diagnostics.empty())
		{
			throw FError(std::move(Diagnostics), ExitUsage);
		}
		Plan = std::move(NewPlan);
	}
	return Plan;
}

/** All zero. */
void MakeConstantBuffers(const FShaderReflection& Reflection, FBoundShader& Out)
{
	Out.ConstantData.resize(Reflection.ConstantBuffers.size());
	Out.ConstantBuffers.resize(Reflection.ConstantBuffers.size());
	for (size_t Buffer = 0; Buffer < Reflection.ConstantBuffers.size(); ++Buffer)
	{
		Out.ConstantData[Buffer].assign(Reflection.ConstantBuffers[Buffer].Size, 0);
		Out.ConstantBuffers[Buffer] = Out.ConstantData[Buffer].data();
	}
}

void MakeResourceSlots(const FShaderReflection& Reflection, FBoundShader& Out)
{
	Out.Textures.resize(Reflection.Textures.size());
	Out.TextureOwners.resize(Reflection.Textures.size());
	Out.RWTextures.resize(Reflection.RWTextures.size());
	Out.RWTextureOwners.resize(Reflection.RWTextures.size());
	Out.Samplers.resize(Reflection.Samplers.size());
	Out.Buffers.resize(Reflection.Buffers.size());
	Out.RWBuffers.resize(Reflection.RWBuffers.size());
}

} // namespace

std::vector<FDiagnostic> MatchShaderParameters(
	const std::string& ShaderName, const FShaderReflection& Reflection, const FShaderParametersMetadata& Metadata)
{
	std::vector<FDiagnostic> Diagnostics;
	MakeShaderBindingPlan(ShaderName, Reflection, Metadata, Diagnostics);
	return Diagnostics;
}

std::vector<std::string> ListBoundResources(FShader& Shader)
{
	FShaderState& State = Shader.GetState();
	std::lock_guard Lock(State.Mutex);
	std::vector<std::string> Names;
	for (const auto& [Metadata, Plan] : State.Plans)
	{
		for (const FResourceCopy& Copy : Plan->Resources)
		{
			const std::string& Buffer = Plan->Sources[Copy.Source].CodeName;
			Names.push_back(Copy.Source == 0 ? Copy.CodeName : Buffer + "->" + Copy.CodeName.substr(Buffer.size() + 1));
		}
	}
	return Names;
}

void FollowShaderBindingPlan(
	const FShaderBindingPlan& Plan, const FShaderReflection& Reflection, const void* Parameters, FBoundShader& Out)
{
	CheckRequiredParameters(Plan, Out.Name, Parameters);
	CheckBoundKinds(Plan, Reflection, Out.Name, Parameters);
	const std::vector<const void*> Contents = ToVector<const void*>(Plan.Sources,
		[&](const FBindingSource& Source) { return Source.bUsed ? GetContents(Source, Parameters) : nullptr; });

	Out.Parameters = Parameters;
	MakeConstantBuffers(Reflection, Out);
	for (const FConstantCopy& Copy : Plan.Constants)
	{
		std::memcpy(Out.ConstantData[Copy.Buffer].data() + Copy.Offset,
			static_cast<const uint8*>(Contents[Copy.Source]) + Copy.SourceOffset, Copy.Size);
	}

	MakeResourceSlots(Reflection, Out);
	for (const FResourceCopy& Copy : Plan.Resources)
	{
		const void* const Source = Contents[Copy.Source];
		switch (Copy.List)
		{
		case EResourceList::Textures:
			Out.Textures[Copy.Slot] = GetTexture(Copy, Source, Out.TextureOwners[Copy.Slot]);
			break;
		case EResourceList::RWTextures:
			Out.RWTextures[Copy.Slot] = GetTexture(Copy, Source, Out.RWTextureOwners[Copy.Slot]);
			break;
		case EResourceList::Samplers:
			Out.Samplers[Copy.Slot] = ReadPointer<FRHISamplerState>(Source, Copy.SourceOffset)->GetKernelSampler();
			break;
		case EResourceList::Buffers:
			Out.Buffers[Copy.Slot] = GetBuffer(Copy, Source);
			break;
		case EResourceList::RWBuffers:
			Out.RWBuffers[Copy.Slot] = Reflection.RWBuffers[Copy.Slot].CounterOf.empty()
										   ? GetBuffer(Copy, Source)
										   : GetView(Copy, Source).GetKernelCounter();
			break;
		}
	}
	for (const FStaticSamplerCopy& Copy : Plan.StaticSamplers)
	{
		Out.Samplers[Copy.Slot] = Copy.Sampler->GetKernelSampler();
	}
}

namespace
{

/** A pixel shader samples a texture that has mips, and does not say at which level. */
bool ChoosesMips(const FBoundShader& Bound)
{
	const std::vector<FShaderResource>& Textures = Bound.GetReflection().Textures;
	for (size_t Slot = 0; Slot < Textures.size(); ++Slot)
	{
		if (Textures[Slot].bImplicitLevel && Bound.Textures[Slot].NumMips > 1)
		{
			return true;
		}
	}
	return false;
}

} // namespace

void BindShaderParameters(
	const FShaderRef& Shader, const FShaderParametersMetadata& Metadata, const void* Parameters, FBoundShader& Out)
{
	const FShaderType& Type = *Shader.GetType();
	Out.Name = Type.GetName();
	Out.EntryPoint = Type.GetFunctionName();
	Out.PermutationId = Shader->GetPermutationId();
	Out.Permutation = Shader.GetShader();
	Out.bDouble = GetShaderLaneConfig().bDouble;
	const std::shared_ptr<const FCompiledShader> Compiled = GetCompiledShader(Shader);
	if (FindNativeKernel(Type, Compiled->Fingerprint, Out.Native) == ENativeChoice::Edited)
	{
		Out.Edited = Type.GetShaderFilename();
	}
	Out.Kernel = Compiled->Run;
	Out.Key = Compiled->Key;
	Out.Vertex = Compiled->Vertex;
	Out.Reflection = std::shared_ptr<const FShaderReflection>(Compiled, &Compiled->Reflection);
	const std::shared_ptr<const FShaderBindingPlan> Plan = GetPlan(Shader, *Out.Reflection, Metadata);
	FollowShaderBindingPlan(*Plan, *Out.Reflection, Parameters, Out);
	CheckStrides(*Plan, Out, Parameters);
	if (!Out.Native && !Compiled->Reflection.bQuads && ChoosesMips(Out))
	{
		const std::shared_ptr<const FCompiledShader> ByQuads = GetCompiledShader(Shader, true);
		Out.Kernel = ByQuads->Run;
		Out.Key = ByQuads->Key;
		Out.Reflection = std::shared_ptr<const FShaderReflection>(ByQuads, &ByQuads->Reflection);
	}
	ReportDroppedComponents(*Plan, *Out.Reflection, Out.Name, Parameters);
}

void BindShaderParameters(const FShaderRef& Shader, const void* Parameters, FBoundShader& Out)
{
	const FShaderParametersMetadata* const Metadata = Shader.GetRootParametersMetadata();
	checkf(Metadata, TEXT("%s has no SHADER_USE_PARAMETER_STRUCT"), Shader.GetType()->GetName());
	BindShaderParameters(Shader, *Metadata, Parameters, Out);
}

void RequireShaderParameters(
	const FShaderRef& Shader, const FShaderParametersMetadata& Metadata, const void* Parameters)
{
	if (IsRun(Shader))
	{
		const std::shared_ptr<const FShaderBindingPlan> Plan = GetPlan(Shader, *GetShaderReflection(Shader), Metadata);
		CheckRequiredParameters(*Plan, Shader.GetType()->GetName(), Parameters);
	}
}

FBoundShader BindToBeSet(FShader& Shader)
{
	const std::shared_ptr<const FCompiledShader> Compiled = GetCompiledShader(FShaderRef(&Shader));
	const FShaderReflection& Reflection = Compiled->Reflection;
	FBoundShader Bound;
	Bound.Name = Shader.GetType()->GetName();
	Bound.EntryPoint = Shader.GetType()->GetFunctionName();
	Bound.PermutationId = Shader.GetPermutationId();
	Bound.Permutation = &Shader;
	Bound.bDouble = GetShaderLaneConfig().bDouble;
	Bound.Kernel = Compiled->Run;
	Bound.Key = Compiled->Key;
	Bound.Vertex = Compiled->Vertex;
	Bound.Reflection = std::shared_ptr<const FShaderReflection>(Compiled, &Reflection);
	MakeConstantBuffers(Reflection, Bound);
	MakeResourceSlots(Reflection, Bound);
	return Bound;
}

namespace
{

/** The name of something that the shader reads of parameters; empty: nothing. */
std::string FindParameter(const FShaderReflection& Reflection)
{
	for (const FShaderConstant& Constant : Reflection.Constants)
	{
		if (Constant.bUsed && !IsBoundByDraw(Reflection, Reflection.ConstantBuffers[Constant.Buffer].Name))
		{
			return Constant.Name;
		}
	}
	for (const auto* Resources : {&Reflection.Textures, &Reflection.RWTextures, &Reflection.Samplers,
			 &Reflection.Buffers, &Reflection.RWBuffers})
	{
		if (!Resources->empty())
		{
			return Resources->front().Name;
		}
	}
	return {};
}

FBoundShader BindWithoutParameters(FShader& Shader)
{
	FBoundShader Bound = BindToBeSet(Shader);
	if (const std::string Parameter = FindParameter(Bound.GetReflection()); !Parameter.empty())
	{
		const char* const Kinds[] = {"vertex", "pixel", "compute"};
		const int Kind = Shader.GetFrequency() == SF_Vertex ? 0 : Shader.GetFrequency() == SF_Pixel ? 1 : 2;
		throw FError(MakeVertexDiagnostic(ESeverity::Error, ErrorVertexInput,
						 std::string(Kinds[Kind]) + " shader " + Bound.Name + " reads '" + Parameter +
							 "', and its parameters were not set: call SetShaderParameters for it, after the pipeline "
							 "state and before the " +
							 (Kind == 2 ? "dispatch" : "draw")),
			ExitUsage);
	}
	return Bound;
}

[[maybe_unused]] const bool GBinderIsSet = (SetShaderBinder(&BindWithoutParameters), true);

} // namespace

} // namespace Drydock
