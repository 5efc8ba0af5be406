// Follows a binding plan inside a pass, and checks before it that everything the shader reads is there.
#include "ShaderBinding.h"

#include "NativeKernels.h"
#include "RenderGraphErrors.h"
#include "RHIResources.h"
#include "RenderGraphReport.h"
#include "RenderGraphResources.h"
#include "RunningCode.h"
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

constexpr uint32 PointerSize = 8;

static_assert(sizeof(TUniformBufferBinding<int>) == PointerSize && sizeof(TRDGUniformBufferBinding<int>) == PointerSize,
	"members that hold one resource are one pointer, which the binder reads without knowing their type");

template<typename T>
T* ReadPointer(const void* Contents, uint32 Offset)
{
	T* Pointer = nullptr;
	std::memcpy(&Pointer, static_cast<const uint8*>(Contents) + Offset, PointerSize);
	return Pointer;
}

/** Contents of a source: the parameter struct itself, or the uniform buffer that its member holds (null when it holds
 * none). */
const void* GetContents(const FBindingSource& Source, const void* Parameters)
{
	if (Source.BaseType == UBMT_REFERENCED_STRUCT)
	{
		const FRHIUniformBuffer* Buffer = ReadPointer<const FRHIUniformBuffer>(Parameters, Source.Offset);
		return Buffer ? Buffer->GetContents() : nullptr;
	}
	if (Source.BaseType == UBMT_RDG_UNIFORM_BUFFER)
	{
		const FRDGUniformBuffer* Buffer = ReadPointer<const FRDGUniformBuffer>(Parameters, Source.Offset);
		return Buffer ? Buffer->GetContents() : nullptr;
	}
	return Parameters;
}

FKernelTexture GetTexture(const FResourceCopy& Copy, const void* Contents)
{
	switch (Copy.BaseType)
	{
	case UBMT_TEXTURE:
		return ReadPointer<FRHITexture>(Contents, Copy.SourceOffset)->GetKernelView();
	case UBMT_SRV:
		return ReadPointer<FRHIShaderResourceView>(Contents, Copy.SourceOffset)->GetKernelTexture();
	case UBMT_UAV:
		return ReadPointer<FRHIUnorderedAccessView>(Contents, Copy.SourceOffset)->GetKernelTexture();
	case UBMT_RDG_TEXTURE:
		return ReadPointer<FRDGTexture>(Contents, Copy.SourceOffset)->GetRHI()->GetKernelView();
	case UBMT_RDG_TEXTURE_SRV:
		return ReadPointer<FRDGTextureSRV>(Contents, Copy.SourceOffset)->GetRHI()->GetKernelTexture();
	case UBMT_RDG_TEXTURE_UAV:
		return ReadPointer<FRDGTextureUAV>(Contents, Copy.SourceOffset)->GetRHI()->GetKernelTexture();
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

const FRHIUnorderedAccessView& GetView(const FResourceCopy& Copy, const void* Contents)
{
	return Copy.BaseType == UBMT_UAV ? *ReadPointer<FRHIUnorderedAccessView>(Contents, Copy.SourceOffset)
									 : *ReadPointer<FRDGBufferUAV>(Contents, Copy.SourceOffset)->GetRHI();
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
		}
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

/** Where the struct declares a member, for a message. */
std::string DescribeDeclaration(const FShaderParametersMetadata& Metadata, const std::string& CodeName)
{
	for (const FHlslMember& Member : Metadata.GetHlslMembers())
	{
		if (Member.CodeName == CodeName && Member.DeclaredIn)
		{
			return std::string(" (declared at ") + Member.DeclaredIn->GetFileName() + ":" +
				   std::to_string(Member.FileLine) + ")";
		}
	}
	return "";
}

FDiagnostic MakeParameterDiagnostic(int32 Code, const std::string& CodeName, const std::string& Message)
{
	FDiagnostic Diagnostic;
	Diagnostic.Code = Code;
	Diagnostic.Message = Message;
	Diagnostic.Where = "parameter " + CodeName;
	const FCodeOwner* const Pass = GetRunningCode();
	if (Pass && !Pass->Pass.empty())
	{
		Diagnostic.Where = "pass " + Pass->Pass + ", " + Diagnostic.Where;
		Diagnostic.File = Pass->File;
		Diagnostic.Line = Pass->Line;
	}
	return Diagnostic;
}

/** Throws, in the engine's words, one message for each uniform buffer and resource that the shader reads and that is
 * not there. */
void CheckRequiredParameters(const FShaderBindingPlan& Plan, const std::string& ShaderName, const void* Parameters)
{
	std::vector<FDiagnostic> Unset;
	const FShaderParametersMetadata& Struct = *Plan.Sources[0].Metadata;
	const auto Require = [&](const void* Contents, uint32 Offset, const std::string& CodeName)
	{
		if (Contents && ReadPointer<void>(Contents, Offset))
		{
			return;
		}
		Unset.push_back(MakeParameterDiagnostic(RDGErrorUnsetParameter, CodeName,
			ShaderName + "'s required shader parameter " + Struct.GetStructTypeName() + "::" + CodeName +
				" was not set." + DescribeDeclaration(Struct, CodeName)));
	};
	for (const FBindingSource& Source : Plan.Sources)
	{
		if (Source.bUsed && Source.BaseType != UBMT_INVALID)
		{
			Require(Parameters, Source.Offset, Source.CodeName);
		}
	}
	for (const FResourceCopy& Copy : Plan.Resources)
	{
		// Of a uniform buffer that is not there, its own message tells.
		if (const void* const Contents = GetContents(Plan.Sources[Copy.Source], Parameters))
		{
			Require(Contents, Copy.SourceOffset, Copy.CodeName);
		}
	}
	if (!Unset.empty())
	{
		throw FError(std::move(Unset), ExitUsage);
	}
}

/** The texture that a copy takes, itself or through a view. */
const FRHITexture* FindBoundTexture(const FResourceCopy& Copy, const void* Contents)
{
	switch (Copy.BaseType)
	{
	case UBMT_TEXTURE:
		return ReadPointer<FRHITexture>(Contents, Copy.SourceOffset);
	case UBMT_SRV:
		return ReadPointer<FRHIShaderResourceView>(Contents, Copy.SourceOffset)->GetTexture();
	case UBMT_RDG_TEXTURE:
		return ReadPointer<FRDGTexture>(Contents, Copy.SourceOffset)->GetRHI();
	case UBMT_RDG_TEXTURE_SRV:
		return ReadPointer<FRDGTextureSRV>(Contents, Copy.SourceOffset)->GetRHI()->GetTexture();
	default:
		return nullptr;
	}
}

/** What a view is read as that does not have the counter for it; empty: it has. */
std::string FindMissingCounter(const FShaderResource& Counter, const FRHIUnorderedAccessView& View)
{
	const bool bAppend = View.SupportsAppendBuffer();
	const bool bAtomic = View.SupportsAtomicCounter();
	const std::string Without = ", and the UAV was created without FRDGBufferUAVDesc::";
	switch (Counter.Counter)
	{
	case EShaderCounter::Append:
		return bAppend ? ""
					   : "an AppendStructuredBuffer or ConsumeStructuredBuffer" + Without + "bSupportsAppendBuffer";
	case EShaderCounter::Atomic:
		return bAtomic ? "" : "a RWStructuredBuffer with a counter" + Without + "bSupportsAtomicCounter";
	default:
		return bAppend || bAtomic
				   ? ""
				   : "a buffer with a counter" + Without + "bSupportsAppendBuffer or bSupportsAtomicCounter";
	}
}

/** Throws where a shader reads a cube and no cube is bound, or the other way, where it compares by a sampler that has
 * nothing to compare by, and where it counts by a view without a counter. A view of a cube may be read as its faces. */
void CheckBoundKinds(const FShaderBindingPlan& Plan, const FShaderReflection& Reflection, const std::string& ShaderName,
	const void* Parameters)
{
	std::vector<FDiagnostic> Wrong;
	const auto Report = [&Wrong, &ShaderName](
							const FResourceCopy& Copy, const FShaderResource& Resource, const std::string& What)
	{
		const std::string Where = Resource.Where.empty() ? std::string("the shader") : Resource.Where;
		Wrong.push_back(MakeParameterDiagnostic(ResourceType, Copy.CodeName,
			ShaderName + ": '" + (Resource.CounterOf.empty() ? Resource.Name : Resource.CounterOf) + "' is read by " +
				Where + " as " + What));
	};
	for (const FResourceCopy& Copy : Plan.Resources)
	{
		const void* const Contents = GetContents(Plan.Sources[Copy.Source], Parameters);
		if (!Contents)
		{
			continue;
		}
		const FRHITexture* const Texture =
			Copy.List == EResourceList::Textures ? FindBoundTexture(Copy, Contents) : nullptr;
		if (Texture)
		{
			const FShaderResource& Resource = Reflection.Textures[Copy.Slot];
			const bool bCube = Resource.Dimension == EShaderDimension::TextureCube;
			const bool bView = Copy.BaseType == UBMT_SRV || Copy.BaseType == UBMT_RDG_TEXTURE_SRV;
			if (bCube != Texture->GetDesc().IsTextureCube() && (bCube || !bView))
			{
				Report(Copy, Resource,
					std::string(bCube ? "a TextureCube, and the texture " : "no cube, and the texture ") +
						Texture->GetName().ToString().ToStdString() + (bCube ? " is none" : " is one"));
			}
		}
		if (Copy.List == EResourceList::RWBuffers && !Reflection.RWBuffers[Copy.Slot].CounterOf.empty())
		{
			const FShaderResource& Counter = Reflection.RWBuffers[Copy.Slot];
			if (const std::string What = FindMissingCounter(Counter, GetView(Copy, Contents)); !What.empty())
			{
				Report(Copy, Counter, What);
			}
		}
		if (Copy.List == EResourceList::Samplers && Reflection.Samplers[Copy.Slot].bCompares)
		{
			const FRHISamplerState* const State = ReadPointer<FRHISamplerState>(Contents, Copy.SourceOffset);
			if (State->GetInitializer().SamplerComparisonFunction == SCF_Never)
			{
				Report(Copy, Reflection.Samplers[Copy.Slot],
					"a SamplerComparisonState, and the sampler state has no SamplerComparisonFunction (SCF_Less)");
			}
		}
	}
	if (!Wrong.empty())
	{
		throw FError(std::move(Wrong), ExitUsage);
	}
}

/** Says where a shader stores more components than the texture keeps. That is no mistake, but often one:
 * three-component formats are stored to as float4 everywhere, those of one or two seldom on purpose. */
void ReportDroppedComponents(const FShaderBindingPlan& Plan, const FShaderReflection& Reflection,
	const std::string& ShaderName, const void* Parameters)
{
	constexpr int32 MaxRemarkable = 2;
	for (const FResourceCopy& Copy : Plan.Resources)
	{
		const void* const Contents = GetContents(Plan.Sources[Copy.Source], Parameters);
		if (Copy.List != EResourceList::RWTextures || Copy.BaseType != UBMT_RDG_TEXTURE_UAV || !Contents)
		{
			continue;
		}
		const FRDGTextureUAVDesc& View = ReadPointer<FRDGTextureUAV>(Contents, Copy.SourceOffset)->Desc;
		const FShaderResource& Resource = Reflection.RWTextures[Copy.Slot];
		const FPixelFormatInfo& Format =
			GPixelFormats[View.Format == PF_Unknown ? View.Texture->Desc.Format : View.Format];
		if (Format.NumComponents <= MaxRemarkable && Resource.NumComponents > Format.NumComponents)
		{
			FDiagnostic Diagnostic;
			Diagnostic.Severity = ESeverity::Note;
			Diagnostic.Code = RDGNoteDroppedComponents;
			Diagnostic.Where = ShaderName + ", parameter " + Copy.CodeName;
			Diagnostic.Message = "the shader stores " + std::to_string(Resource.NumComponents) + " components, and " +
								 View.Texture->Name + " is " + Format.Name + ", which keeps " +
								 std::to_string(Format.NumComponents);
			ReportRDGWarning(Diagnostic, true);
		}
	}
}

} // namespace

std::vector<FDiagnostic> MatchShaderParameters(
	const std::string& ShaderName, const FShaderReflection& Reflection, const FShaderParametersMetadata& Metadata)
{
	std::vector<FDiagnostic> Diagnostics;
	MakeShaderBindingPlan(ShaderName, Reflection, Metadata, Diagnostics);
	return Diagnostics;
}

void FollowShaderBindingPlan(
	const FShaderBindingPlan& Plan, const FShaderReflection& Reflection, const void* Parameters, FBoundShader& Out)
{
	CheckRequiredParameters(Plan, Out.Name, Parameters);
	CheckBoundKinds(Plan, Reflection, Out.Name, Parameters);
	std::vector<const void*> Contents;
	for (const FBindingSource& Source : Plan.Sources)
	{
		Contents.push_back(Source.bUsed ? GetContents(Source, Parameters) : nullptr);
	}

	Out.Parameters = Parameters;
	MakeConstantBuffers(Reflection, Out);
	for (const FConstantCopy& Copy : Plan.Constants)
	{
		std::memcpy(Out.ConstantData[Copy.Buffer].data() + Copy.Offset,
			static_cast<const uint8*>(Contents[Copy.Source]) + Copy.SourceOffset, Copy.Size);
	}

	Out.Textures.resize(Reflection.Textures.size());
	Out.RWTextures.resize(Reflection.RWTextures.size());
	Out.Samplers.resize(Reflection.Samplers.size());
	Out.Buffers.resize(Reflection.Buffers.size());
	Out.RWBuffers.resize(Reflection.RWBuffers.size());
	for (const FResourceCopy& Copy : Plan.Resources)
	{
		const void* const Source = Contents[Copy.Source];
		switch (Copy.List)
		{
		case EResourceList::Textures:
			Out.Textures[Copy.Slot] = GetTexture(Copy, Source);
			break;
		case EResourceList::RWTextures:
			Out.RWTextures[Copy.Slot] = GetTexture(Copy, Source);
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
	Out.Native = FindNativeKernel(Type);
	const std::shared_ptr<const FCompiledShader> Compiled = GetCompiledShader(Shader);
	Out.Kernel = Compiled->Run;
	Out.Vertex = Compiled->Vertex;
	Out.Reflection = std::shared_ptr<const FShaderReflection>(Compiled, &Compiled->Reflection);
	const std::shared_ptr<const FShaderBindingPlan> Plan = GetPlan(Shader, *Out.Reflection, Metadata);
	FollowShaderBindingPlan(*Plan, *Out.Reflection, Parameters, Out);
	if (!Out.Native && !Compiled->Reflection.bQuads && ChoosesMips(Out))
	{
		const std::shared_ptr<const FCompiledShader> ByQuads = GetCompiledShader(Shader, true);
		Out.Kernel = ByQuads->Run;
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

FBoundShader BindVertexShaderWithoutParameters(FShader& Shader)
{
	const std::shared_ptr<const FCompiledShader> Compiled = GetCompiledShader(FShaderRef(&Shader));
	const FShaderType& Type = *Shader.GetType();
	if (const std::string Parameter = FindParameter(Compiled->Reflection); !Parameter.empty())
	{
		throw FError(MakeVertexDiagnostic(ESeverity::Error, ErrorVertexInput,
						 std::string("vertex shader ") + Type.GetName() + " reads '" + Parameter +
							 "', and its parameters were not set: call SetShaderParameters for it, after the pipeline "
							 "state and before the draw"),
			ExitUsage);
	}
	FBoundShader Bound;
	Bound.Name = Type.GetName();
	Bound.EntryPoint = Type.GetFunctionName();
	Bound.PermutationId = Shader.GetPermutationId();
	Bound.Reflection = std::shared_ptr<const FShaderReflection>(Compiled, &Compiled->Reflection);
	Bound.Vertex = Compiled->Vertex;
	MakeConstantBuffers(Compiled->Reflection, Bound);
	return Bound;
}

[[maybe_unused]] const bool GBinderIsSet = (SetVertexShaderBinder(&BindVertexShaderWithoutParameters), true);

} // namespace

} // namespace Drydock
