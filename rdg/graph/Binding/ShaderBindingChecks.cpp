// Walks the binding plan beside the parameters that it will read.
#include "ShaderBindingChecks.h"

#include "BoundContents.h"
#include "RenderGraphErrors.h"
#include "RenderGraphReport.h"
#include "RunningCode.h"

namespace Drydock
{

namespace
{

/** " (declared at FILE:LINE)" of a struct's member, for a message. */
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

/** Describes what the shader reads a view as, if the view lacks the counter for it; else empty. */
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

} // namespace

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
		// A uniform buffer that was not set has its own message.
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

void CheckStrides(const FShaderBindingPlan& Plan, const FBoundShader& Bound, const void* Parameters)
{
	std::vector<FDiagnostic> Wrong;
	for (const FResourceCopy& Copy : Plan.Resources)
	{
		const bool bWritten = Copy.List == EResourceList::RWBuffers;
		if (!bWritten && Copy.List != EResourceList::Buffers)
		{
			continue;
		}
		const FShaderReflection& Reflection = Bound.GetReflection();
		const FShaderResource& Resource = (bWritten ? Reflection.RWBuffers : Reflection.Buffers)[Copy.Slot];
		const FKernelBuffer& Buffer = (bWritten ? Bound.RWBuffers : Bound.Buffers)[Copy.Slot];
		if (Resource.Dimension != EShaderDimension::StructuredBuffer || !Resource.CounterOf.empty() ||
			Resource.Stride == Buffer.Stride)
		{
			continue;
		}
		const void* const Contents = GetContents(Plan.Sources[Copy.Source], Parameters);
		const FRDGBuffer* const Graphs = Copy.BaseType == UBMT_RDG_BUFFER_SRV
											 ? ReadPointer<FRDGBufferSRV>(Contents, Copy.SourceOffset)->Desc.Buffer
										 : Copy.BaseType == UBMT_RDG_BUFFER_UAV
											 ? ReadPointer<FRDGBufferUAV>(Contents, Copy.SourceOffset)->Desc.Buffer
											 : nullptr;
		Wrong.push_back(MakeParameterDiagnostic(ResourceType, Copy.CodeName,
			Bound.Name + ": '" + Resource.Name + "' has elements of " + std::to_string(Resource.Stride) +
				" bytes where it is read by " + (Resource.Where.empty() ? "the shader" : Resource.Where) +
				", and the buffer " + (Graphs ? std::string(Graphs->Name) + " " : std::string()) +
				"was created with elements of " + std::to_string(Buffer.Stride) +
				": give FRDGBufferDesc::CreateStructuredDesc the size of the struct that the shader declares"));
	}
	if (!Wrong.empty())
	{
		throw FError(std::move(Wrong), ExitUsage);
	}
}

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

} // namespace Drydock
