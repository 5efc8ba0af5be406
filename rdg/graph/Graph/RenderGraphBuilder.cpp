// Creates the builder's resources, and opens and closes its life; RenderGraphBuilderPasses.cpp has the passes.
// Behaviour is the engine's.
#include "RenderGraphBuilder.h"

#include "CodeScope.h"
#include "PrintText.h"
#include "RenderGraphExecute.h"
#include "RenderGraphHeap.h"
#include "RenderGraphReport.h"
#include "RenderGraphState.h"
#include "RenderResource.h"

#include <cstdio>
#include <exception>

using namespace Drydock;

namespace
{

FRDGBuilder* GActiveBuilder = nullptr;

/** Most graphs have no more passes, nor resources: their descriptions are not moved as they grow. */
constexpr size_t NumUsual = 64;

std::string DescribeWhere(const char* Kind, const TCHAR* Name)
{
	return std::string(Kind) + " " + (Name ? Name : "<unnamed>");
}

/** Kept for the end; the graph goes on being declared. */
void AddError(FRDGBuilderState& State, int Code, const std::string& Message, const std::string& Where)
{
	if (State.Settings.bValidation)
	{
		FDiagnostic& Diagnostic = State.Errors.emplace_back();
		Diagnostic.Code = Code;
		Diagnostic.Message = Message;
		Diagnostic.Where = Where;
		Diagnostic = AddRunningWords(Diagnostic);
	}
}

const TCHAR* CheckName(FRDGBuilderState& State, const TCHAR* Name, const char* Kind)
{
	if (!Name)
	{
		AddError(State, RDGErrorNullName, std::string("a ") + Kind + " must have a name", DescribeWhere(Kind, Name));
	}
	return Name ? Name : TEXT("<unnamed>");
}

FRDGResourceDescription DescribeTexture(const FRDGTexture& Texture, const FRDGSettings& Settings)
{
	const FRDGTextureDesc& Desc = Texture.Desc;
	const FRDGTextureSubresourceLayout Layout = Texture.GetSubresourceLayout();
	FRDGResourceDescription Description;
	Description.Name = Texture.Name;
	Description.Kind = ERDGResourceKind::Texture;
	Description.Format = Desc.Format;
	Description.Extent = FIntVector(Desc.Extent.X, Desc.Extent.Y, Desc.Depth);
	Description.NumMips = int32(Layout.NumMips);
	Description.NumSlices = int32(Layout.NumArraySlices);
	Description.NumPlanes = int32(Layout.NumPlaneSlices);
	Description.NumSamples = Desc.NumSamples;
	Description.TextureFlags = Desc.Flags;
	Description.Bytes = FRHITexture::ComputeSize(Desc);
	Description.bSkipTracking = EnumHasAnyFlags(Texture.Flags, ERDGTextureFlags::SkipTracking);
	Description.bMayBeTransient = !EnumHasAnyFlags(Desc.Flags, TexCreate_Shared) &&
								  (Settings.TransientAllocator != 2 || EnumHasAnyFlags(Desc.Flags, TexCreate_FastVRAM));
	return Description;
}

void DescribeBufferSize(const FRDGBuffer& Buffer, FRDGResourceDescription& Description)
{
	Description.Extent = FIntVector(int32(Buffer.Desc.NumElements), int32(Buffer.Desc.BytesPerElement), 1);
	Description.Bytes = FRHIBuffer::ComputeSize(Translate(Buffer.Desc));
}

FRDGResourceDescription DescribeBuffer(const FRDGBuffer& Buffer, const FRDGSettings& Settings)
{
	FRDGResourceDescription Description;
	Description.Name = Buffer.Name;
	Description.Kind = ERDGResourceKind::Buffer;
	Description.BufferUsage = Buffer.Desc.Usage;
	DescribeBufferSize(Buffer, Description);
	Description.bSkipTracking = EnumHasAnyFlags(Buffer.Flags, ERDGBufferFlags::SkipTracking);
	Description.bMayBeTransient =
		EnumHasAnyFlags(Buffer.Desc.Usage, EBufferUsageFlags::UnorderedAccess) &&
		(Settings.bTransientIndirectArguments ||
			!EnumHasAnyFlags(Buffer.Desc.Usage, EBufferUsageFlags::DrawIndirect)) &&
		(Settings.TransientAllocator != 2 || EnumHasAnyFlags(Buffer.Desc.Usage, EBufferUsageFlags::FastVRAM));
	return Description;
}

} // namespace

// Life --------------------------------------------------------------------------------------------------------------

FRDGBuilder::FRDGBuilder(FRHICommandListImmediate& InRHICmdList, FRDGEventName InName, ERDGBuilderFlags)
	: RHICmdList(InRHICmdList)
	, State(std::make_unique<FRDGBuilderState>())
{
	if (GActiveBuilder)
	{
		// The heap is shared, so this one is fatal at once.
		ThrowRDGError(RDGErrorSecondBuilder,
			"another FRDGBuilder already exists on the stack; only one may be alive at a time",
			std::string("graph ") + InName.GetTCHAR());
	}
	InitGlobalResources();
	GActiveBuilder = this;
	State->Settings = GetRDGSettings();
	State->UncaughtExceptions = std::uncaught_exceptions();
	State->Graph.Name = InName.GetTCHAR();
	State->Graph.Passes.reserve(NumUsual);
	State->Graph.Resources.reserve(NumUsual);
	State->PassResources.reserve(NumUsual);
	FRDGPassDescription& Prologue = State->Graph.Passes.emplace_back();
	Prologue.Index = 0;
	Prologue.Name = "Graph Prologue";
	Prologue.bIsSentinel = true;
}

FRDGBuilder::~FRDGBuilder()
{
	GActiveBuilder = nullptr;
	if (!State->bFinished && !State->bFailed && std::uncaught_exceptions() == State->UncaughtExceptions)
	{
		const FDiagnostic Diagnostic = AddRunningWords({ESeverity::Error, RDGErrorNotExecuted,
			"the builder must be executed: FRDGBuilder was destroyed without a call of Execute", {}, 0, 0,
			"graph " + State->Graph.Name});
		PrintText(stderr, Diagnostic.ToString() + "\n");
		std::terminate();
	}
}

void FRDGBuilder::Fail(int Code, const std::string& Message, const std::string& Where) const
{
	State->bFailed = true;
	ThrowRDGError(Code, Message, Where);
}

void FRDGBuilder::RequireOpen(const char* Call) const
{
	if (State->bFinished)
	{
		Fail(RDGErrorAfterExecute, std::string(Call) + " was called after Execute", "graph " + State->Graph.Name);
	}
}

void FRDGBuilder::CheckKnown(const void* Object, ERDGObject Kinds, const char* Call, const char* Parameter,
	const Drydock::FSourceLocation* Location) const
{
	if (Object && State->Known.Has(Object, Kinds))
	{
		return;
	}
	State->bFailed = true;
	FDiagnostic Diagnostic;
	Diagnostic.Code = Object ? RDGErrorForeignResource : RDGErrorNullArgument;
	Diagnostic.Message = Object
							 ? "the parameter points to something that is not of this graph (left from another graph, "
							   "or deleted)"
							 : "the parameter is null";
	Diagnostic.File = Location ? Location->File : "";
	Diagnostic.Line = Location ? int(Location->Line) : 0;
	Diagnostic.Where = std::string(Call) + ", parameter " + Parameter;
	ThrowRDGErrors({Diagnostic});
}

FRDGAllocator& FRDGBuilder::GetAllocator()
{
	return State->Allocator;
}

void FRDGBuilder::Discard()
{
	// Once executed there is nothing left to tell, and the observer may be gone.
	const bool bTell = !State->bFinished && State->Observer != nullptr;
	State->bFinished = true;
	for (const TRDGPlaced<FRDGPass>& Pass : State->Passes)
	{
		if (bTell)
		{
			State->Observer->OnPassPlanned(Pass->GetIndex(), *Pass);
		}
	}
	if (bTell && State->Observer->WantsPlannedExternals())
	{
		State->Observer->OnExternalsPlanned(FRDGExecutor(*State, RHICmdList).PlanExternals(Compile()));
	}
}

void FRDGBuilder::SetObserver(IRDGObserver* Observer)
{
	State->Observer = Observer;
}

bool FRDGBuilder::IsImmediateMode()
{
	return GetRDGSettings().bImmediateMode;
}

void FRDGBuilder::TickPoolElements()
{
	GRenderTargetPool.TickPoolElements();
	GRenderGraphResourcePool.TickPoolElements();
	TickTransientHeap();
}

// Textures and buffers ----------------------------------------------------------------------------------------------

/** Makes an object that goes with the graph, once it is adopted. */
template<typename ObjectType, typename... ArgumentTypes>
ObjectType* FRDGBuilder::Place(ArgumentTypes&&... Arguments)
{
	return new (State->Allocator.AllocUninitialized(sizeof(ObjectType), alignof(ObjectType)))
		ObjectType(std::forward<ArgumentTypes>(Arguments)...);
}

FRDGTextureRef FRDGBuilder::CreateTexture(const FRDGTextureDesc& Desc, const TCHAR* InName, ERDGTextureFlags Flags)
{
	RequireOpen("CreateTexture");
	const TCHAR* const Name = CheckName(*State, InName, "texture");
	FString Reason;
	if (!Desc.IsValid(&Reason))
	{
		Fail(RDGErrorInvalidDescription, std::string("the texture cannot be created: ") + *Reason,
			DescribeWhere("texture", Name));
	}
	if (EnumHasAnyFlags(Desc.Flags, TexCreate_Presentable))
	{
		AddError(*State, RDGErrorResourceFlags,
			"presentable textures (TexCreate_Presentable) are not created by a graph", DescribeWhere("texture", Name));
	}
	if (Desc.NumSamples > 1 && EnumHasAnyFlags(Desc.Flags, TexCreate_UAV))
	{
		AddError(*State, RDGErrorResourceFlags, "a multisampled texture cannot have TexCreate_UAV",
			DescribeWhere("texture", Name));
	}
	if (EnumHasAnyFlags(Flags, ERDGTextureFlags::SkipTracking))
	{
		AddError(*State, RDGErrorResourceFlags, "SkipTracking is for registered (external) textures only",
			DescribeWhere("texture", Name));
	}
	auto* const Texture = Place<FRDGTexture>(Name, Desc, Flags);
	AdoptResource(Texture, DescribeTexture(*Texture, State->Settings));
	return Texture;
}

FRDGBufferRef FRDGBuilder::CreateBuffer(const FRDGBufferDesc& Desc, const TCHAR* InName, ERDGBufferFlags Flags)
{
	RequireOpen("CreateBuffer");
	const TCHAR* const Name = CheckName(*State, InName, "buffer");
	FRDGBufferDesc ValidDesc = Desc;
	if (Desc.GetSize() == 0)
	{
		AddError(*State, RDGErrorInvalidDescription, "the buffer has zero bytes", DescribeWhere("buffer", Name));
		ValidDesc.BytesPerElement = FMath::Max(Desc.BytesPerElement, 1u);
		ValidDesc.NumElements = FMath::Max(Desc.NumElements, 1u);
	}
	if (EnumHasAllFlags(Desc.Usage, EBufferUsageFlags::StructuredBuffer | EBufferUsageFlags::ByteAddressBuffer) &&
		Desc.BytesPerElement != 4)
	{
		AddError(*State, RDGErrorInvalidDescription, "a byte-address buffer has elements of 4 bytes",
			DescribeWhere("buffer", Name));
	}
	if (EnumHasAnyFlags(Flags, ERDGBufferFlags::SkipTracking))
	{
		AddError(*State, RDGErrorResourceFlags, "SkipTracking is for registered (external) buffers only",
			DescribeWhere("buffer", Name));
	}
	auto* const Buffer = Place<FRDGBuffer>(Name, ValidDesc, Flags);
	AdoptResource(Buffer, DescribeBuffer(*Buffer, State->Settings));
	return Buffer;
}

FRDGBufferRef FRDGBuilder::CreateBuffer(const FRDGBufferDesc& Desc, const TCHAR* Name,
	FRDGBufferNumElementsCallback&& NumElementsCallback, ERDGBufferFlags Flags)
{
	FRDGBufferDesc Placeholder = Desc;
	Placeholder.NumElements = FMath::Max(Desc.NumElements, 1u);
	FRDGBufferRef Buffer = CreateBuffer(Placeholder, Name, Flags);
	Buffer->NumElementsCallback = MoveTemp(NumElementsCallback);
	return Buffer;
}

void FRDGBuilder::AdoptResource(FRDGViewableResource* Resource, FRDGResourceDescription&& Description)
{
	Resource->Index = int32(State->Resources.size());
	State->Resources.emplace_back(Resource);
	State->Graph.Resources.push_back(MoveTemp(Description));
	State->Known.Add(
		Resource, Resource->Type == ERDGViewableResourceType::Texture ? ERDGObject::Texture : ERDGObject::Buffer);
}

void FRDGBuilder::ResolveBufferSizes()
{
	for (const TRDGPlaced<FRDGViewableResource>& Resource : State->Resources)
	{
		if (Resource->Type != ERDGViewableResourceType::Buffer)
		{
			continue;
		}
		auto& Buffer = static_cast<FRDGBuffer&>(*Resource);
		if (Buffer.NumElementsCallback && !Buffer.HasRHI())
		{
			Buffer.Desc.NumElements = FMath::Max(Buffer.NumElementsCallback(), 1u);
			DescribeBufferSize(Buffer, State->GetDescription(Buffer));
		}
	}
}

// Views -------------------------------------------------------------------------------------------------------------

FRDGTextureRef FRDGBuilder::CheckParent(FRDGTextureRef Texture) const
{
	if (!Texture)
	{
		Fail(RDGErrorNullArgument, "a view was created of a null texture", "CreateSRV or CreateUAV");
	}
	return Texture;
}

template<typename ViewType>
ViewType* FRDGBuilder::AdoptView(ViewType* View)
{
	View->ViewIndex = int32(State->Views.size());
	State->Views.emplace_back(View);
	State->Known.Add(View, GetKinds(View));
	return View;
}

FRDGTextureSRVRef FRDGBuilder::CreateSRV(const FRDGTextureSRVDesc& Desc)
{
	CheckOwn(Desc.Texture, "CreateSRV");
	const FRDGTextureSubresourceLayout Layout = Desc.Texture->GetSubresourceLayout();
	if (Desc.MipLevel + FMath::Max<uint32>(Desc.NumMipLevels, 1) > Layout.NumMips ||
		Desc.FirstArraySlice + FMath::Max<uint32>(Desc.NumArraySlices, 1) > Layout.NumArraySlices)
	{
		Fail(RDGErrorView, "the view covers mips or slices that the texture does not have",
			DescribeWhere("texture", Desc.Texture->Name));
	}
	return AdoptView(Place<FRDGTextureSRV>(Desc));
}

FRDGBufferSRVRef FRDGBuilder::CreateSRV(const FRDGBufferSRVDesc& Desc)
{
	CheckOwn(Desc.Buffer, "CreateSRV");
	return AdoptView(Place<FRDGBufferSRV>(Desc));
}

FRDGTextureUAVRef FRDGBuilder::CreateUAV(const FRDGTextureUAVDesc& Desc, ERDGUnorderedAccessViewFlags Flags)
{
	CheckOwn(Desc.Texture, "CreateUAV");
	const FRDGTextureSubresourceLayout Layout = Desc.Texture->GetSubresourceLayout();
	if (Desc.MipLevel >= Layout.NumMips ||
		Desc.FirstArraySlice + FMath::Max<uint32>(Desc.NumArraySlices, 1) > Layout.NumArraySlices)
	{
		Fail(RDGErrorView,
			"the UAV is of mip " + std::to_string(Desc.MipLevel) + ", but the texture has " +
				std::to_string(Layout.NumMips) + " mips and " + std::to_string(Layout.NumArraySlices) + " slices",
			DescribeWhere("texture", Desc.Texture->Name));
	}
	if (!EnumHasAnyFlags(Desc.Texture->Desc.Flags, TexCreate_UAV))
	{
		AddError(*State, RDGErrorView, "a UAV was created of a texture without TexCreate_UAV",
			DescribeWhere("texture", Desc.Texture->Name));
	}
	return AdoptView(Place<FRDGTextureUAV>(Desc, Flags));
}

FRDGBufferUAVRef FRDGBuilder::CreateUAV(const FRDGBufferUAVDesc& Desc, ERDGUnorderedAccessViewFlags Flags)
{
	CheckOwn(Desc.Buffer, "CreateUAV");
	if (!EnumHasAnyFlags(Desc.Buffer->Desc.Usage, EBufferUsageFlags::UnorderedAccess))
	{
		AddError(*State, RDGErrorView, "a UAV was created of a buffer without BUF_UnorderedAccess",
			DescribeWhere("buffer", Desc.Buffer->Name));
	}
	const bool bStructured =
		EnumHasAnyFlags(Desc.Buffer->Desc.Usage, EBufferUsageFlags::StructuredBuffer) && Desc.Format == PF_Unknown;
	if ((Desc.bSupportsAtomicCounter || Desc.bSupportsAppendBuffer) && !bStructured)
	{
		Fail(RDGErrorView,
			std::string("a UAV was created with ") +
				(Desc.bSupportsAppendBuffer ? "bSupportsAppendBuffer" : "bSupportsAtomicCounter") +
				" of a buffer that is not structured (FRDGBufferDesc::CreateStructuredDesc), or with a format",
			DescribeWhere("buffer", Desc.Buffer->Name));
	}
	return AdoptView(Place<FRDGBufferUAV>(Desc, Flags));
}

void FRDGBuilder::CheckUniformBufferParameters(const void* Parameters, const FShaderParametersMetadata* Metadata)
{
	RequireOpen("CreateUniformBuffer");
	if (!Parameters)
	{
		Fail(RDGErrorNullArgument, "CreateUniformBuffer was called with null parameters",
			DescribeWhere("uniform buffer", Metadata->GetStructTypeName()));
	}
}

void FRDGBuilder::AdoptUniformBuffer(FRDGUniformBuffer* Buffer)
{
	State->UniformBuffers.emplace_back(Buffer);
	State->Known.Add(Buffer, ERDGObject::UniformBuffer);
}

// External resources ------------------------------------------------------------------------------------------------

FRDGTextureRef FRDGBuilder::RegisterExternalTexture(
	const TRefCountPtr<IPooledRenderTarget>& ExternalPooledTexture, ERDGTextureFlags Flags)
{
	const TCHAR* const Name = ExternalPooledTexture ? ExternalPooledTexture->GetDesc().DebugName : nullptr;
	return RegisterExternalTexture(ExternalPooledTexture, Name ? Name : TEXT("External"), Flags);
}

FRDGTextureRef FRDGBuilder::RegisterExternalTexture(const TRefCountPtr<IPooledRenderTarget>& ExternalPooledTexture,
	const TCHAR* NameIfNotRegistered, ERDGTextureFlags Flags)
{
	RequireOpen("RegisterExternalTexture");
	const TCHAR* const Name = CheckName(*State, NameIfNotRegistered, "external texture");
	if (!ExternalPooledTexture || !ExternalPooledTexture->GetRHI())
	{
		Fail(RDGErrorNullArgument, "attempted to register a NULL external texture", DescribeWhere("texture", Name));
	}
	FRHITexture* const TextureRHI = ExternalPooledTexture->GetRHI();
	if (FRDGTextureRef Registered = FindExternalTexture(TextureRHI))
	{
		return Registered;
	}
	auto* const Texture = Place<FRDGTexture>(Name, TextureRHI->GetDesc(), Flags);
	AdoptResource(Texture, DescribeTexture(*Texture, State->Settings));
	Texture->PooledTexture = ExternalPooledTexture;
	Texture->ResourceRHI = TextureRHI;
	Texture->bExternal = Texture->bRegistered = Texture->bProduced = true;
	State->GetDescription(*Texture).bExternal = true;
	State->GetDescription(*Texture).bMayBeTransient = false;
	State->ExternalTextures[TextureRHI] = Texture;
	return Texture;
}

FRDGBufferRef FRDGBuilder::RegisterExternalBuffer(
	const TRefCountPtr<FRDGPooledBuffer>& ExternalPooledBuffer, ERDGBufferFlags Flags)
{
	const TCHAR* const Name = ExternalPooledBuffer ? ExternalPooledBuffer->GetName() : nullptr;
	return RegisterExternalBuffer(ExternalPooledBuffer, Name ? Name : TEXT("External"), Flags);
}

FRDGBufferRef FRDGBuilder::RegisterExternalBuffer(
	const TRefCountPtr<FRDGPooledBuffer>& ExternalPooledBuffer, const TCHAR* NameIfNotRegistered, ERDGBufferFlags Flags)
{
	RequireOpen("RegisterExternalBuffer");
	const TCHAR* const Name = CheckName(*State, NameIfNotRegistered, "external buffer");
	if (!ExternalPooledBuffer || !ExternalPooledBuffer->GetRHI())
	{
		Fail(RDGErrorNullArgument, "attempted to register a NULL external buffer", DescribeWhere("buffer", Name));
	}
	if (FRDGBufferRef Registered = FindExternalBuffer(ExternalPooledBuffer->GetRHI()))
	{
		return Registered;
	}
	auto* const Buffer = Place<FRDGBuffer>(Name, ExternalPooledBuffer->GetDesc(), Flags);
	AdoptResource(Buffer, DescribeBuffer(*Buffer, State->Settings));
	Buffer->PooledBuffer = ExternalPooledBuffer;
	Buffer->ResourceRHI = ExternalPooledBuffer->GetRHI();
	Buffer->bExternal = Buffer->bRegistered = Buffer->bProduced = true;
	State->GetDescription(*Buffer).bExternal = true;
	State->GetDescription(*Buffer).bMayBeTransient = false;
	State->ExternalBuffers[ExternalPooledBuffer->GetRHI()] = Buffer;
	return Buffer;
}

FRDGTextureRef FRDGBuilder::FindExternalTexture(FRHITexture* Texture) const
{
	const auto Found = State->ExternalTextures.find(Texture);
	return Found == State->ExternalTextures.end() ? nullptr : Found->second;
}

FRDGTextureRef FRDGBuilder::FindExternalTexture(IPooledRenderTarget* ExternalPooledTexture) const
{
	return ExternalPooledTexture ? FindExternalTexture(ExternalPooledTexture->GetRHI()) : nullptr;
}

FRDGBufferRef FRDGBuilder::FindExternalBuffer(FRHIBuffer* Buffer) const
{
	const auto Found = State->ExternalBuffers.find(Buffer);
	return Found == State->ExternalBuffers.end() ? nullptr : Found->second;
}

FRDGBufferRef FRDGBuilder::FindExternalBuffer(FRDGPooledBuffer* ExternalPooledBuffer) const
{
	return ExternalPooledBuffer ? FindExternalBuffer(ExternalPooledBuffer->GetRHI()) : nullptr;
}
