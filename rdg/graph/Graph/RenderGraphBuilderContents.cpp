// Says what a builder takes in and gives out: uploads, extractions, conversions to external, access modes. Behaviour is
// the engine's.
#include "RenderGraphBuilder.h"

#include "CodeScope.h"
#include "RenderGraphExecute.h"
#include "RenderGraphReport.h"
#include "RenderGraphState.h"

#include <cstring>

using namespace Drydock;

namespace
{

BEGIN_SHADER_PARAMETER_STRUCT(FAccessModePassParameters, )
	RDG_TEXTURE_ACCESS_DYNAMIC(Texture)
	RDG_BUFFER_ACCESS_DYNAMIC(Buffer)
END_SHADER_PARAMETER_STRUCT()

/** Which flags a pass needs to be allowed an access. */
ERDGPassFlags GetFlagsFor(ERHIAccess Access)
{
	const ERHIAccess Copy = ERHIAccess::CopySrc | ERHIAccess::CopyDest;
	return EnumHasAnyFlags(Access, Copy) ? ERDGPassFlags::Copy | ERDGPassFlags::Compute : ERDGPassFlags::Compute;
}

} // namespace

void FRDGBuilder::CheckOwn(const void* Object, ERDGObject Kinds, const char* Call) const
{
	RequireOpen(Call);
	if (!Object)
	{
		Fail(
			RDGErrorNullArgument, std::string(Call) + " was called with a null resource", "graph " + State->Graph.Name);
	}
	if (!State->Known.Has(Object, Kinds))
	{
		Fail(RDGErrorForeignResource, std::string(Call) + " was called with a resource that is not of this graph",
			"graph " + State->Graph.Name);
	}
}

void FRDGBuilder::AddResourceError(int Code, const std::string& Message, const FRDGResource& Resource)
{
	if (State->Settings.bValidation)
	{
		FDiagnostic& Diagnostic = State->Errors.emplace_back();
		Diagnostic.Code = Code;
		Diagnostic.Message = Message;
		Diagnostic.Where = std::string("resource ") + Resource.Name;
		Diagnostic = AddRunningWords(Diagnostic);
	}
}

// Uploads -----------------------------------------------------------------------------------------------------------

void FRDGBuilder::QueueBufferUpload(
	FRDGBufferRef Buffer, const void* InitialData, uint64 InitialDataSize, ERDGInitialDataFlags InitialDataFlags)
{
	CheckOwn(Buffer, "QueueBufferUpload");
	if (Buffer->bQueuedForUpload)
	{
		AddResourceError(RDGErrorUpload,
			"the buffer already has an upload queued: only one upload can be done for each graph", *Buffer);
		return;
	}
	if (!InitialData && InitialDataSize > 0)
	{
		Fail(RDGErrorNullArgument, "QueueBufferUpload was called with null data",
			std::string("resource ") + Buffer->Name);
	}
	if (InitialDataSize > Buffer->GetSize())
	{
		Fail(RDGErrorUpload,
			std::to_string(InitialDataSize) + " bytes were queued for upload into a buffer of " +
				std::to_string(Buffer->GetSize()),
			std::string("resource ") + Buffer->Name);
	}
	FRDGUpload& Upload = State->Uploads[Buffer];
	Upload.Size = InitialDataSize;
	Upload.Data = InitialData;
	if (InitialDataSize > 0 && !EnumHasAnyFlags(InitialDataFlags, ERDGInitialDataFlags::NoCopy))
	{
		void* const Copy = Alloc(InitialDataSize);
		std::memcpy(Copy, InitialData, InitialDataSize);
		Upload.Data = Copy;
	}
	Buffer->bQueuedForUpload = true;
	Buffer->bProduced = true;
	State->GetDescription(*Buffer).bUploaded = true;
}

// Extraction and conversion -----------------------------------------------------------------------------------------

bool FRDGBuilder::CheckExtraction(FRDGViewableResource* Resource, const void* Out, const char* Call)
{
	CheckOwn(Resource, Call);
	if (!Out)
	{
		Fail(RDGErrorNullArgument, std::string(Call) + " was called with a null output pointer",
			std::string("resource ") + Resource->Name);
	}
	if (!Resource->bProduced)
	{
		AddResourceError(RDGErrorExtraction,
			"the resource was not produced by any pass yet, nor registered or uploaded: it cannot be extracted",
			*Resource);
		return false;
	}
	Resource->bExtracted = true;
	Resource->bForceNonTransient = true;
	FRDGResourceDescription& Description = State->GetDescription(*Resource);
	Description.bExtracted = true;
	Description.bMayBeTransient = false; // it outlives the heap
	return true;
}

void FRDGBuilder::QueueTextureExtraction(
	FRDGTextureRef Texture, TRefCountPtr<IPooledRenderTarget>* OutPooledTexturePtr, ERDGResourceExtractionFlags)
{
	if (CheckExtraction(Texture, OutPooledTexturePtr, "QueueTextureExtraction"))
	{
		State->TextureExtractions.push_back({Texture, OutPooledTexturePtr});
	}
}

void FRDGBuilder::QueueTextureExtraction(FRDGTextureRef Texture, TRefCountPtr<IPooledRenderTarget>* OutPooledTexturePtr,
	ERHIAccess AccessFinal, ERDGResourceExtractionFlags Flags)
{
	QueueTextureExtraction(Texture, OutPooledTexturePtr, Flags);
	SetTextureAccessFinal(Texture, AccessFinal);
}

void FRDGBuilder::QueueBufferExtraction(
	FRDGBufferRef Buffer, TRefCountPtr<FRDGPooledBuffer>* OutPooledBufferPtr, ERDGResourceExtractionFlags)
{
	if (CheckExtraction(Buffer, OutPooledBufferPtr, "QueueBufferExtraction"))
	{
		State->BufferExtractions.push_back({Buffer, OutPooledBufferPtr});
	}
}

void FRDGBuilder::QueueBufferExtraction(FRDGBufferRef Buffer, TRefCountPtr<FRDGPooledBuffer>* OutPooledBufferPtr,
	ERHIAccess AccessFinal, ERDGResourceExtractionFlags Flags)
{
	QueueBufferExtraction(Buffer, OutPooledBufferPtr, Flags);
	SetBufferAccessFinal(Buffer, AccessFinal);
}

void FRDGBuilder::ConvertToExternal(FRDGViewableResource* Resource)
{
	if (Resource->bExternal)
	{
		return;
	}
	ResolveBufferSizes();
	if (!Resource->HasRHI())
	{
		FRDGExecutor::AllocatePooled(*Resource);
	}
	Resource->bExternal = true;
	Resource->bForceNonTransient = true;
	State->GetDescription(*Resource).bExternal = true;
	State->GetDescription(*Resource).bMayBeTransient = false;
}

const TRefCountPtr<IPooledRenderTarget>& FRDGBuilder::ConvertToExternalTexture(FRDGTextureRef Texture)
{
	CheckOwn(Texture, "ConvertToExternalTexture");
	ConvertToExternal(Texture);
	State->ExternalTextures[static_cast<FRHITexture*>(Texture->ResourceRHI.GetReference())] = Texture;
	return Texture->PooledTexture;
}

const TRefCountPtr<FRDGPooledBuffer>& FRDGBuilder::ConvertToExternalBuffer(FRDGBufferRef Buffer)
{
	CheckOwn(Buffer, "ConvertToExternalBuffer");
	ConvertToExternal(Buffer);
	State->ExternalBuffers[static_cast<FRHIBuffer*>(Buffer->ResourceRHI.GetReference())] = Buffer;
	return Buffer->PooledBuffer;
}

FRHIUniformBuffer* FRDGBuilder::ConvertToExternalUniformBuffer(FRDGUniformBufferRef UniformBuffer)
{
	CheckOwn(UniformBuffer, "ConvertToExternalUniformBuffer");
	FRDGPassDescription Walked;
	const FRDGPassResources Resources = CollectPassResources(
		UniformBuffer->GetMetadata(), UniformBuffer->GetContents(),
		[this](const void* Pointer, ERDGObject Kinds) { return State->Known.Has(Pointer, Kinds); }, Walked);
	for (FRDGViewableResource* Resource : Resources.Viewables)
	{
		ConvertToExternal(Resource);
	}
	if (!UniformBuffer->HasRHI())
	{
		UniformBuffer->ResourceRHI =
			Drydock::CreateUniformBuffer(UniformBuffer->GetMetadata(), UniformBuffer->GetContents()).GetReference();
	}
	return static_cast<FRHIUniformBuffer*>(UniformBuffer->ResourceRHI.GetReference());
}

const TRefCountPtr<IPooledRenderTarget>& FRDGBuilder::GetPooledTexture(FRDGTextureRef Texture) const
{
	CheckOwn(Texture, "GetPooledTexture");
	if (!Texture->bExternal)
	{
		Fail(RDGErrorNullArgument, "GetPooledTexture is for external textures only",
			std::string("resource ") + Texture->Name);
	}
	return Texture->PooledTexture;
}

const TRefCountPtr<FRDGPooledBuffer>& FRDGBuilder::GetPooledBuffer(FRDGBufferRef Buffer) const
{
	CheckOwn(Buffer, "GetPooledBuffer");
	if (!Buffer->bExternal)
	{
		Fail(RDGErrorNullArgument, "GetPooledBuffer is for external buffers only",
			std::string("resource ") + Buffer->Name);
	}
	return Buffer->PooledBuffer;
}

// Access ------------------------------------------------------------------------------------------------------------

void FRDGBuilder::SetAccessFinal(FRDGViewableResource* Resource, ERHIAccess Access, const char* Call)
{
	CheckOwn(Resource, Call);
	if (!Resource->bExternal && !Resource->bExtracted)
	{
		AddResourceError(
			RDGErrorAccessFinal, std::string(Call) + " is for external or extracted resources only", *Resource);
		return;
	}
	Resource->AccessFinal = Access;
	State->GetDescription(*Resource).AccessFinal = Access;
}

void FRDGBuilder::SetTextureAccessFinal(FRDGTextureRef Texture, ERHIAccess Access)
{
	SetAccessFinal(Texture, Access, "SetTextureAccessFinal");
}

void FRDGBuilder::SetBufferAccessFinal(FRDGBufferRef Buffer, ERHIAccess Access)
{
	SetAccessFinal(Buffer, Access, "SetBufferAccessFinal");
}

void FRDGBuilder::AddAccessModePass(FRDGViewableResource* Resource, ERHIAccess Access, bool bExternal)
{
	auto* const Parameters = AllocParameters<FAccessModePassParameters>();
	if (Resource->Type == ERDGViewableResourceType::Texture)
	{
		Parameters->Texture = FRDGTextureAccess(static_cast<FRDGTexture*>(Resource), Access);
	}
	else
	{
		Parameters->Buffer = FRDGBufferAccess(static_cast<FRDGBuffer*>(Resource), Access);
	}
	Resource->ExternalAccess = ERHIAccess::Unknown; // so that this very pass is not reported
	AddPass(RDG_EVENT_NAME("AccessModePass(%s: %s)", bExternal ? "External" : "Internal", Resource->Name), Parameters,
		GetFlagsFor(Access) | ERDGPassFlags::NeverCull,
		[Resource, bExternal](FRHIComputeCommandList&)
		{
			Resource->MarkResourceAsUsed();
			FRDGExecutor::SetExternalAccess(*Resource, bExternal);
		});
}

void FRDGBuilder::UseExternalAccessMode(FRDGViewableResource* Resource, ERHIAccess ReadOnlyAccess, ERHIPipeline)
{
	CheckOwn(Resource, "UseExternalAccessMode");
	if (!IsReadOnlyAccess(ReadOnlyAccess))
	{
		AddResourceError(RDGErrorAccessFlags, "external access mode needs a read-only access", *Resource);
		return;
	}
	Resource->bForceNonTransient = true;
	State->GetDescription(*Resource).bMayBeTransient = false; // code that the graph does not see may hold on to it
	AddAccessModePass(Resource, ReadOnlyAccess, true);
	Resource->ExternalAccess = ReadOnlyAccess;
}

void FRDGBuilder::UseInternalAccessMode(FRDGViewableResource* Resource)
{
	CheckOwn(Resource, "UseInternalAccessMode");
	if (Resource->ExternalAccess != ERHIAccess::Unknown)
	{
		AddAccessModePass(Resource, Resource->ExternalAccess, false);
	}
}

void FRDGBuilder::RemoveUnusedTextureWarning(FRDGTextureRef Texture)
{
	CheckOwn(Texture, "RemoveUnusedTextureWarning");
	State->GetDescription(*Texture).bSkipUnusedWarning = true;
}

void FRDGBuilder::RemoveUnusedBufferWarning(FRDGBufferRef Buffer)
{
	CheckOwn(Buffer, "RemoveUnusedBufferWarning");
	State->GetDescription(*Buffer).bSkipUnusedWarning = true;
}
