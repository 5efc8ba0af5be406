// The render graph. Declare resources and passes, then Execute once: the graph finds out which passes the outputs need,
// places the resources in memory and runs what is left in the order it was added.
//
//     FRDGBuilder GraphBuilder(RHICmdList);
//     FRDGTextureRef Texture = GraphBuilder.CreateTexture(Desc, TEXT("Half"));
//     auto* Parameters = GraphBuilder.AllocParameters<FParameters>();
//     Parameters->Output = GraphBuilder.CreateUAV(Texture);
//     GraphBuilder.AddPass(RDG_EVENT_NAME("Fill"), Parameters, ERDGPassFlags::Compute,
//         [Parameters](FRHIComputeCommandList& RHICmdList) { ... });
//     GraphBuilder.QueueTextureExtraction(Texture, &Result);
//     GraphBuilder.Execute();
//
// Setup runs at once; a pass's lambda runs in Execute, so it captures by value and graph resources by pointer.
// Mistakes are collected and thrown together by Execute as Drydock::FError (DD2xxx); what would touch wrong memory is
// thrown at once. Not for several threads. Source: engine RenderGraphBuilder.h.
#pragma once

#include "RHICommandList.h"
#include "RenderGraphAllocator.h"
#include "RenderGraphBlackboard.h"
#include "RenderGraphCompiled.h"
#include "RenderGraphDefinitions.h"
#include "RenderGraphEvent.h"
#include "RenderGraphObjects.h"
#include "RenderGraphPass.h"
#include "RenderGraphResources.h"
#include "RenderTargetPool.h"
#include "ShaderParameterMacros.h"
#include "SourceLocation.h"

#include <memory>

class DRYDOCK_API FRDGBuilder : private FNoncopyable
{
public:
	/** Only one builder may be alive at a time. */
	explicit FRDGBuilder(FRHICommandListImmediate& InRHICmdList, FRDGEventName InName = {},
		ERDGBuilderFlags InFlags = ERDGBuilderFlags::None);

	/** Prints and terminates when neither Execute nor Discard was called, except while an exception passes through. */
	~FRDGBuilder();

	// Resources -----------------------------------------------------------------------------------------------------

	/** Name is kept as a pointer and must outlive the graph. */
	FRDGTextureRef CreateTexture(
		const FRDGTextureDesc& Desc, const TCHAR* Name, ERDGTextureFlags Flags = ERDGTextureFlags::None);
	FRDGBufferRef CreateBuffer(
		const FRDGBufferDesc& Desc, const TCHAR* Name, ERDGBufferFlags Flags = ERDGBufferFlags::None);

	/** The number of elements is asked for when the graph is executed. */
	FRDGBufferRef CreateBuffer(const FRDGBufferDesc& Desc, const TCHAR* Name,
		FRDGBufferNumElementsCallback&& NumElementsCallback, ERDGBufferFlags Flags = ERDGBufferFlags::None);

	FRDGTextureSRVRef CreateSRV(const FRDGTextureSRVDesc& Desc);
	FRDGTextureSRVRef CreateSRV(FRDGTextureRef Texture)
	{
		return CreateSRV(FRDGTextureSRVDesc::Create(CheckParent(Texture)));
	}
	FRDGBufferSRVRef CreateSRV(const FRDGBufferSRVDesc& Desc);
	FRDGBufferSRVRef CreateSRV(FRDGBufferRef Buffer, EPixelFormat Format)
	{
		return CreateSRV(FRDGBufferSRVDesc(Buffer, Format));
	}
	FRDGBufferSRVRef CreateSRV(FRDGBufferRef Buffer) { return CreateSRV(FRDGBufferSRVDesc(Buffer)); }

	FRDGTextureUAVRef CreateUAV(
		const FRDGTextureUAVDesc& Desc, ERDGUnorderedAccessViewFlags Flags = ERDGUnorderedAccessViewFlags::None);
	/** Creates a view of mip 0. */
	FRDGTextureUAVRef CreateUAV(FRDGTextureRef Texture,
		ERDGUnorderedAccessViewFlags Flags = ERDGUnorderedAccessViewFlags::None, EPixelFormat Format = PF_Unknown)
	{
		return CreateUAV(FRDGTextureUAVDesc(CheckParent(Texture), 0, Format), Flags);
	}
	FRDGBufferUAVRef CreateUAV(
		const FRDGBufferUAVDesc& Desc, ERDGUnorderedAccessViewFlags Flags = ERDGUnorderedAccessViewFlags::None);
	FRDGBufferUAVRef CreateUAV(FRDGBufferRef Buffer, EPixelFormat Format = PF_Unknown,
		ERDGUnorderedAccessViewFlags Flags = ERDGUnorderedAccessViewFlags::None)
	{
		return CreateUAV(FRDGBufferUAVDesc(Buffer, Format), Flags);
	}
	FRDGBufferUAVRef CreateUAV(
		FRDGBufferRef Buffer, ERDGUnorderedAccessViewFlags Flags, EPixelFormat Format = PF_Unknown)
	{
		return CreateUAV(FRDGBufferUAVDesc(Buffer, Format), Flags);
	}

	/** Parameters come from AllocParameters, or live as long as the graph. */
	template<typename ParameterStructType>
	TRDGUniformBufferRef<ParameterStructType> CreateUniformBuffer(const ParameterStructType* Parameters)
	{
		CheckUniformBufferParameters(Parameters, ParameterStructType::FTypeInfo::GetStructMetadata());
		auto* Buffer = new TRDGUniformBuffer<ParameterStructType>(
			Parameters, ParameterStructType::FTypeInfo::GetStructMetadata()->GetStructTypeName());
		AdoptUniformBuffer(Buffer);
		return Buffer;
	}

	// Memory of the graph -------------------------------------------------------------------------------------------

	void* Alloc(uint64 SizeInBytes, uint32 AlignInBytes = 16)
	{
		return GetAllocator().Alloc(SizeInBytes, AlignInBytes);
	}

	template<typename PODType>
	PODType* AllocPOD()
	{
		return static_cast<PODType*>(Alloc(sizeof(PODType), alignof(PODType)));
	}
	template<typename PODType>
	PODType* AllocPODArray(uint32 Count)
	{
		return static_cast<PODType*>(Alloc(sizeof(PODType) * Count, alignof(PODType)));
	}
	template<typename PODType>
	TArrayView<PODType> AllocPODArrayView(uint32 Count)
	{
		return TArrayView<PODType>(AllocPODArray<PODType>(Count), int32(Count));
	}
	/** Destroyed with the graph. */
	template<typename ObjectType, typename... ArgumentTypes>
	ObjectType* AllocObject(ArgumentTypes&&... Arguments)
	{
		return GetAllocator().AllocObject<ObjectType>(std::forward<ArgumentTypes>(Arguments)...);
	}
	template<typename ObjectType>
	TArray<ObjectType>& AllocArray()
	{
		return *AllocObject<TArray<ObjectType>>();
	}
	/** Every member zero or null. */
	template<typename ParameterStructType>
	ParameterStructType* AllocParameters()
	{
		return AllocObject<ParameterStructType>();
	}
	template<typename ParameterStructType>
	ParameterStructType* AllocParameters(const ParameterStructType* StructToCopy)
	{
		check(StructToCopy);
		return AllocObject<ParameterStructType>(*StructToCopy);
	}

	// Passes --------------------------------------------------------------------------------------------------------

	/** Parameters declare what the pass touches; they must not change after the call. Null members are skipped. */
	template<typename ParameterStructType, typename ExecuteLambdaType>
	FRDGPassRef AddPass(FRDGEventName&& Name, const ParameterStructType* ParameterStruct, ERDGPassFlags Flags,
		ExecuteLambdaType&& ExecuteLambda, Drydock::FSourceLocation Location = Drydock::FSourceLocation::Current())
	{
		return AddPass(MoveTemp(Name), ParameterStructType::FTypeInfo::GetStructMetadata(), ParameterStruct, Flags,
			std::forward<ExecuteLambdaType>(ExecuteLambda), Location);
	}

	template<typename ExecuteLambdaType>
	FRDGPassRef AddPass(FRDGEventName&& Name, const FShaderParametersMetadata* ParametersMetadata,
		const void* ParameterStruct, ERDGPassFlags Flags, ExecuteLambdaType&& ExecuteLambda,
		Drydock::FSourceLocation Location = Drydock::FSourceLocation::Current())
	{
		using FLambda = std::decay_t<ExecuteLambdaType>;
		using FPass = TRDGLambdaPass<FLambda>;
		void* const Memory = GetAllocator().AllocUninitialized(sizeof(FPass), alignof(FPass));
		return AdoptPass(new (Memory) FPass(MoveTemp(Name), ParametersMetadata, ParameterStruct, Flags,
			FLambda(std::forward<ExecuteLambdaType>(ExecuteLambda)), Location));
	}

	/** Without parameters: never culled, touches nothing that the graph knows. Flags: None, or NeverCull. */
	template<typename ExecuteLambdaType>
	FRDGPassRef AddPass(FRDGEventName&& Name, ERDGPassFlags Flags, ExecuteLambdaType&& ExecuteLambda,
		Drydock::FSourceLocation Location = Drydock::FSourceLocation::Current())
	{
		return AddPass(MoveTemp(Name), nullptr, static_cast<const void*>(nullptr), Flags,
			std::forward<ExecuteLambdaType>(ExecuteLambda), Location);
	}

	/** Consumer keeps Producer alive. Producer was added first. */
	void AddPassDependency(FRDGPassRef Producer, FRDGPassRef Consumer);

	/** A hint for splitting work between threads; recorded. */
	void SetPassWorkload(FRDGPassRef Pass, uint32 Workload);

	// Contents ------------------------------------------------------------------------------------------------------

	/** At most one upload per buffer. Data is copied unless NoCopy is given. */
	void QueueBufferUpload(FRDGBufferRef Buffer, const void* InitialData, uint64 InitialDataSize,
		ERDGInitialDataFlags InitialDataFlags = ERDGInitialDataFlags::None);
	template<typename ElementType>
	void QueueBufferUpload(FRDGBufferRef Buffer, TArrayView<ElementType> Container,
		ERDGInitialDataFlags InitialDataFlags = ERDGInitialDataFlags::None)
	{
		QueueBufferUpload(Buffer, Container.GetData(), uint64(Container.Num()) * sizeof(ElementType), InitialDataFlags);
	}

	/** Registering one texture twice gives the same resource; the first name stays. */
	FRDGTextureRef RegisterExternalTexture(const TRefCountPtr<IPooledRenderTarget>& ExternalPooledTexture,
		ERDGTextureFlags Flags = ERDGTextureFlags::None);
	FRDGTextureRef RegisterExternalTexture(const TRefCountPtr<IPooledRenderTarget>& ExternalPooledTexture,
		const TCHAR* NameIfNotRegistered, ERDGTextureFlags Flags = ERDGTextureFlags::None);
	FRDGBufferRef RegisterExternalBuffer(
		const TRefCountPtr<FRDGPooledBuffer>& ExternalPooledBuffer, ERDGBufferFlags Flags = ERDGBufferFlags::None);
	FRDGBufferRef RegisterExternalBuffer(const TRefCountPtr<FRDGPooledBuffer>& ExternalPooledBuffer,
		const TCHAR* NameIfNotRegistered, ERDGBufferFlags Flags = ERDGBufferFlags::None);

	/** Null when it was not registered. */
	FRDGTextureRef FindExternalTexture(FRHITexture* Texture) const;
	FRDGTextureRef FindExternalTexture(IPooledRenderTarget* ExternalPooledTexture) const;
	FRDGBufferRef FindExternalBuffer(FRHIBuffer* Buffer) const;
	FRDGBufferRef FindExternalBuffer(FRDGPooledBuffer* ExternalPooledBuffer) const;

	/** Keeps the contents beyond the graph; *OutPooledTexturePtr is written at the end of Execute. */
	void QueueTextureExtraction(FRDGTextureRef Texture, TRefCountPtr<IPooledRenderTarget>* OutPooledTexturePtr,
		ERDGResourceExtractionFlags Flags = ERDGResourceExtractionFlags::None);
	void QueueTextureExtraction(FRDGTextureRef Texture, TRefCountPtr<IPooledRenderTarget>* OutPooledTexturePtr,
		ERHIAccess AccessFinal, ERDGResourceExtractionFlags Flags = ERDGResourceExtractionFlags::None);
	void QueueBufferExtraction(FRDGBufferRef Buffer, TRefCountPtr<FRDGPooledBuffer>* OutPooledBufferPtr,
		ERDGResourceExtractionFlags Flags = ERDGResourceExtractionFlags::None);
	void QueueBufferExtraction(FRDGBufferRef Buffer, TRefCountPtr<FRDGPooledBuffer>* OutPooledBufferPtr,
		ERHIAccess AccessFinal, ERDGResourceExtractionFlags Flags = ERDGResourceExtractionFlags::None);

	/** Allocates at once and makes the resource external: its last writer is never culled. */
	const TRefCountPtr<IPooledRenderTarget>& ConvertToExternalTexture(FRDGTextureRef Texture);
	const TRefCountPtr<FRDGPooledBuffer>& ConvertToExternalBuffer(FRDGBufferRef Buffer);
	/** Everything in the struct as well. The RHI buffer holds the struct as it is now. */
	FRHIUniformBuffer* ConvertToExternalUniformBuffer(FRDGUniformBufferRef UniformBuffer);

	/** External and extracted resources only. */
	const TRefCountPtr<IPooledRenderTarget>& GetPooledTexture(FRDGTextureRef Texture) const;
	const TRefCountPtr<FRDGPooledBuffer>& GetPooledBuffer(FRDGBufferRef Buffer) const;

	/** State to leave an external or extracted resource in. */
	void SetTextureAccessFinal(FRDGTextureRef Texture, ERHIAccess Access);
	void SetBufferAccessFinal(FRDGBufferRef Buffer, ERHIAccess Access);

	/** From here on, in passes that do not declare it, the resource may be read through GetRHI, and only read. */
	void UseExternalAccessMode(
		FRDGViewableResource* Resource, ERHIAccess ReadOnlyAccess, ERHIPipeline Pipelines = ERHIPipeline::Graphics);
	void UseInternalAccessMode(FRDGViewableResource* Resource);

	/** Silences "produced but never used" (r.RDG.Debug) for one resource. */
	void RemoveUnusedTextureWarning(FRDGTextureRef Texture);
	void RemoveUnusedBufferWarning(FRDGBufferRef Buffer);

	// Events and the rest -------------------------------------------------------------------------------------------

	void BeginEventScope(FRDGEventName&& ScopeName);
	void EndEventScope();
	/** Opens a scope inside which no scope is recorded. */
	void BeginFinalEventScope(FRDGEventName&& ScopeName);

	/** Runs the function at once. */
	void AddSetupTask(TUniqueFunction<void()>&& Task) { Task(); }
	template<typename TaskType>
	void AddCommandListSetupTask(TaskType&& Task)
	{
		Task(RHICmdList);
	}
	void AddDispatchHint() {}
	void FlushSetupQueue() {}

	/** Compiles, runs the surviving passes in the order they were added, writes extracted pointers. Once. */
	void Execute();

	/** r.RDG.ImmediateMode is on: AddPass runs its lambda before it returns. */
	static bool IsImmediateMode();

	/** End of a frame for the pools behind all graphs. */
	static void TickPoolElements();

	// Drydock's own -------------------------------------------------------------------------------------------------

	/** Compiles the graph as Execute would do. Executes nothing; throws what Execute would throw. Not after Execute:
	 * DD2004. */
	Drydock::FRDGCompiledGraph Compile();

	/** Ends the graph without executing it. */
	void Discard();

	/** Opens a scope that is not an event: passes added in it belong to that effect (FRDGPassDescription::Effect).
	 * Closed by EndEventScope; see FRDGEffectScope. */
	void BeginEffectScope(const char* Effect);

	/** Throws (DD2006, DD2013) unless Object is one of this graph: a texture, buffer, view, uniform buffer or pass.
	 * Call and Parameter name the place in the message, and Location that of the call. Only the pointer is looked at,
	 * which may be any. */
	template<typename ObjectType>
	void CheckArgument(const ObjectType* Object, const char* Call, const char* Parameter,
		const Drydock::FSourceLocation* Location = nullptr) const
	{
		CheckKnown(Object, Drydock::GetKinds(Object), Call, Parameter, Location);
	}

	/** Null for none. Must outlive the builder or be reset. */
	void SetObserver(Drydock::IRDGObserver* Observer);

	FRHICommandListImmediate& RHICmdList;
	FRDGBlackboard Blackboard;

private:
	Drydock::FRDGAllocator& GetAllocator();
	FRDGPassRef AdoptPass(FRDGPass* Pass); // which lies in the graph's memory
	void AdoptUniformBuffer(FRDGUniformBuffer* Buffer);
	void CheckUniformBufferParameters(const void* Parameters, const FShaderParametersMetadata* Metadata);
	template<typename ObjectType, typename... ArgumentTypes>
	ObjectType* Place(ArgumentTypes&&... Arguments);
	void AdoptResource(FRDGViewableResource* Resource, Drydock::FRDGResourceDescription&& Description);
	template<typename ViewType>
	ViewType* AdoptView(ViewType* View);
	void DeclarePass(FRDGPass& Pass);
	[[noreturn]] void Fail(int Code, const std::string& Message, const std::string& Where) const;
	void RequireOpen(const char* Call) const;
	void CheckKnown(const void* Object, Drydock::ERDGObject Kinds, const char* Call, const char* Parameter,
		const Drydock::FSourceLocation* Location) const;
	FRDGTextureRef CheckParent(FRDGTextureRef Texture) const;
	template<typename ObjectType>
	void CheckOwn(const ObjectType* Object, const char* Call) const
	{
		CheckOwn(Object, Drydock::GetKinds(Object), Call);
	}
	void CheckOwn(const void* Object, Drydock::ERDGObject Kinds, const char* Call) const;
	bool CheckExtraction(FRDGViewableResource* Resource, const void* Out, const char* Call);
	void AddResourceError(int Code, const std::string& Message, const FRDGResource& Resource);
	void ThrowCollectedErrors(const std::vector<Drydock::FDiagnostic>& GraphErrors);
	std::vector<Drydock::FDiagnostic> CheckGraph();
	Drydock::FRDGCompiledGraph Compile(Drydock::FRDGGraphDescription Graph);
	void ResolveBufferSizes();
	void ConvertToExternal(FRDGViewableResource* Resource);
	void SetAccessFinal(FRDGViewableResource* Resource, ERHIAccess Access, const char* Call);
	void AddAccessModePass(FRDGViewableResource* Resource, ERHIAccess Access, bool bExternal);
	void OpenScope(const FRDGEventName& ScopeName, bool bFinal);

	std::unique_ptr<Drydock::FRDGBuilderState> State;
};

/** Opens a scope of a builder and closes it at the end of the block. */
class DRYDOCK_API FRDGEventScopeGuard : private FNoncopyable
{
public:
	FRDGEventScopeGuard(
		FRDGBuilder& InGraphBuilder, FRDGEventName&& ScopeName, bool bCondition = true, bool bFinal = false);
	~FRDGEventScopeGuard();

private:
	FRDGBuilder& GraphBuilder;
	bool bOpened;
};

namespace Drydock
{

/** Names the effect whose passes are added until the end of the block; null or empty: no effect's, as those of a view
 * extension. */
class DRYDOCK_API FRDGEffectScope : private FNoncopyable
{
public:
	FRDGEffectScope(FRDGBuilder& InGraphBuilder, const char* Effect);
	~FRDGEffectScope();

private:
	FRDGBuilder& GraphBuilder;
};

} // namespace Drydock

/** Memory of the graph for the data of an upload: fill it, and give it to QueueBufferUpload with NoCopy. It begins as
 * zeros, where the engine's is undefined. */
template<typename ElementType>
class FRDGUploadData : public TArrayView<ElementType>
{
public:
	FRDGUploadData() = default;
	FRDGUploadData(FRDGBuilder& GraphBuilder, uint32 Count)
		: TArrayView<ElementType>(GraphBuilder.AllocPODArrayView<ElementType>(Count))
	{
		static_assert(std::is_trivially_copyable_v<ElementType>, "Uploads are copied as bytes");
		std::fill_n(reinterpret_cast<uint8*>(this->GetData()), GetTotalSize(), uint8(0));
	}

	/** In bytes. */
	uint32 GetTotalSize() const { return static_cast<uint32>(this->NumBytes()); }
};
