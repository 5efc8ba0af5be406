// Runs the passes of a compiled graph, or one pass at a time in immediate mode.
#include "RenderGraphExecute.h"

#include "CodeScope.h"
#include "DiagnosticList.h"
#include "DispatchReuse.h"
#include "PrintText.h"
#include "RangeTools.h"
#include "RenderGraphAlias.h"
#include "RenderGraphClobber.h"
#include "RenderGraphDump.h"
#include "RenderGraphHeap.h"
#include "RenderGraphObserver.h"
#include "RenderGraphReport.h"
#include "ShaderCompilation.h"
#include "ShaderParameterMacros.h"

#include <algorithm>
#include <chrono>
#include <cstring>

namespace Drydock
{

IRDGObserver::~IRDGObserver() = default;

/** Passes and resources learn what became of them. */
void FRDGExecutor::TakeOver(const FRDGCompiledGraph& InCompiled)
{
	Compiled = &InCompiled;
	for (size_t Index = 0; Index < State.Passes.size(); ++Index)
	{
		State.Passes[Index]->bCulled = InCompiled.Passes[Index + 1].bCulled;
	}
	for (size_t Index = 0; Index < State.Resources.size(); ++Index)
	{
		State.Resources[Index]->bCulled = InCompiled.Resources[Index].FirstPass < 0;
		State.Resources[Index]->bTransient = InCompiled.Resources[Index].bTransient;
	}
}

std::vector<FRDGExternalLoad> FRDGExecutor::PlanExternals(const FRDGCompiledGraph& InCompiled)
{
	TakeOver(InCompiled);
	CompileShaders();
	return FindExternals(-1);
}

void FRDGExecutor::RunGraph(const FRDGCompiledGraph& InCompiled)
{
	TakeOver(InCompiled);
	LogTransitions(InCompiled);
	if (State.Observer)
	{
		State.Observer->OnGraphCompiled(InCompiled);
	}
	CompileShaders();
	LoadExternals(FindExternals(-1));
	if (InCompiled.Memory.TransientPeakBytes > 0)
	{
		Heap = ReserveTransientHeap(InCompiled.Memory.TransientPeakBytes);
	}
	for (const TRDGPlaced<FRDGPass>& Pass : State.Passes)
	{
		if (!Pass->bCulled)
		{
			RunPass(*Pass);
		}
	}
	WriteExtractions();
}

/** All at once, so that the messages of all broken shaders come together and no pass is charged for a compiler. */
void FRDGExecutor::CompileShaders()
{
	std::vector<FShaderRef> Shaders;
	for (const TRDGPlaced<FRDGPass>& Pass : State.Passes)
	{
		for (const FShaderRef Shader : {FShaderRef(Pass->ShaderToCompile), FShaderRef(Pass->VertexShaderToCompile)})
		{
			if (!Pass->bCulled && Shader.IsValid() && !Contains(Shaders, Shader))
			{
				Shaders.push_back(Shader);
			}
		}
	}
	WarmShaders(Shaders);
}

void FRDGExecutor::RunPassImmediately(FRDGPass& Pass)
{
	LoadExternals(FindExternals(Pass.GetIndex()));
	RunPass(Pass);
}

void FRDGExecutor::FinishImmediate(const FRDGCompiledGraph& InCompiled)
{
	LogTransitions(InCompiled);
	if (State.Observer)
	{
		State.Observer->OnGraphCompiled(InCompiled);
	}
	WriteExtractions();
}

namespace
{

enum class EExternalUse
{
	None,
	Possible,
	Read,
};

/** How a pass uses a resource among its Viewables. A uniform buffer names more than a shader reads. */
EExternalUse GetExternalUse(const FRDGPassResources& Resources, const FRDGViewableResource* Resource,
	const std::vector<std::shared_ptr<const FShaderReflection>>& Shaders)
{
	bool bInUniformBuffer = false;
	for (const FRDGUniformBufferResource& Member : Resources.InUniformBuffers)
	{
		if (Member.Resource != Resource)
		{
			continue;
		}
		bInUniformBuffer = true;
		const auto IsMember = [&Member](const FShaderResource& Read)
		{
			return Read.Name == Member.HlslName;
		};
		for (const std::shared_ptr<const FShaderReflection>& Shader : Shaders)
		{
			if (std::ranges::any_of(Shader->Textures, IsMember))
			{
				return EExternalUse::Read;
			}
		}
	}
	return !bInUniformBuffer ? EExternalUse::Read : Shaders.empty() ? EExternalUse::Possible : EExternalUse::None;
}

} // namespace

/** Registered textures that a pass (-1: any surviving one) uses and that were not announced yet. */
std::vector<FRDGExternalLoad> FRDGExecutor::FindExternals(int32 PassIndex)
{
	std::vector<FRDGExternalLoad> Found;
	const size_t First = PassIndex < 0 ? 0 : size_t(PassIndex) - 1;
	const size_t Last = PassIndex < 0 ? State.Passes.size() : First + 1;
	for (size_t Index = First; Index < Last; ++Index)
	{
		const FRDGPass& Pass = *State.Passes[Index];
		if (PassIndex < 0 && Pass.bCulled)
		{
			continue;
		}
		const FRDGPassResources& Resources = State.PassResources[Index];
		std::vector<std::shared_ptr<const FShaderReflection>> Shaders;
		for (FShader* const Shader : {Pass.ShaderToCompile, Pass.VertexShaderToCompile})
		{
			if (Pass.ShaderToCompile && Shader && !Resources.InUniformBuffers.empty())
			{
				Shaders.push_back(GetShaderReflection(FShaderRef(Shader)));
			}
		}
		for (FRDGViewableResource* Resource : Resources.Viewables)
		{
			if (!Resource->bRegistered || Resource->Type != ERDGViewableResourceType::Texture)
			{
				continue;
			}
			const EExternalUse Use = GetExternalUse(Resources, Resource, Shaders);
			const bool bRead = Use == EExternalUse::Read;
			const FRDGExternalLoad Load{static_cast<FRDGTexture*>(Resource), &Pass, bRead};
			if (Use == EExternalUse::None)
			{
				continue;
			}
			const auto [Known, bNew] = State.LoadedExternals.try_emplace(Load.Texture, bRead);
			if (!bNew && (Known->second || !bRead))
			{
				continue;
			}
			Known->second = bRead;
			const auto Earlier = std::ranges::find(Found, Load.Texture, &FRDGExternalLoad::Texture);
			if (Earlier != Found.end())
			{
				*Earlier = Load;
			}
			else
			{
				Found.push_back(Load);
			}
		}
	}
	return Found;
}

void FRDGExecutor::LoadExternals(const std::vector<FRDGExternalLoad>& Loads)
{
	if (!State.Observer || Loads.empty())
	{
		return;
	}
	for (const FRDGExternalLoad& Load : Loads)
	{
		Load.Texture->bAllowRHIAccess = true;
	}
	State.Observer->OnLoadExternals(Loads);
	for (const FRDGExternalLoad& Load : Loads)
	{
		Load.Texture->bAllowRHIAccess = Load.Texture->bExternalAccessNow;
	}
}

// Memory ------------------------------------------------------------------------------------------------------------

void FRDGExecutor::AllocatePooled(FRDGViewableResource& Resource)
{
	if (Resource.Type == ERDGViewableResourceType::Texture)
	{
		auto& Texture = static_cast<FRDGTexture&>(Resource);
		Texture.PooledTexture = GRenderTargetPool.FindFreeElement(Texture.Desc, Texture.Name);
		Texture.ResourceRHI = Texture.PooledTexture->GetRHI();
	}
	else
	{
		auto& Buffer = static_cast<FRDGBuffer&>(Resource);
		Buffer.PooledBuffer = GRenderGraphResourcePool.FindFreeBuffer(Buffer.Desc, Buffer.Name);
		Buffer.ResourceRHI = Buffer.PooledBuffer->GetRHI();
	}
}

void FRDGExecutor::Allocate(FRDGViewableResource& Resource)
{
	if (Resource.HasRHI())
	{
		return;
	}
	if (!Resource.bTransient)
	{
		AllocatePooled(Resource);
		return;
	}
	uint8* const Memory = Heap + Compiled->Resources[size_t(Resource.Index)].HeapOffset;
	if (Resource.Type == ERDGViewableResourceType::Texture)
	{
		const TRefCountPtr<FRHITexture> Texture(
			new FRHITexture(static_cast<FRDGTexture&>(Resource).Desc, Resource.Name));
		Texture->PlaceAt(Memory);
		Resource.ResourceRHI = Texture.GetReference();
	}
	else
	{
		const TRefCountPtr<FRHIBuffer> Buffer(
			new FRHIBuffer(Translate(static_cast<FRDGBuffer&>(Resource).Desc), Resource.Name));
		Buffer->PlaceAt(Memory);
		Resource.ResourceRHI = Buffer.GetReference();
	}
}

/** Before the first pass that touches it, not earlier: its place in the heap may belong to another until then. */
void FRDGExecutor::MakeReady(FRDGViewableResource& Resource)
{
	if (Resource.bReady)
	{
		return;
	}
	Allocate(Resource);
	Resource.bReady = true;
	if (Resource.bQueuedForUpload)
	{
		Upload(static_cast<FRDGBuffer&>(Resource));
		return;
	}
	if (Resource.bExternal)
	{
		return;
	}
	if (State.Settings.ClobberResources == 0 || !PassesRDGGraphFilter(State.Graph.Name.c_str()) ||
		!PassesRDGResourceFilter(Resource.Name))
	{
		const bool bReuse = GetReuseCache() != nullptr; // old contents would be part of each result
		if (Resource.Type == ERDGViewableResourceType::Texture)
		{
			auto& Texture = static_cast<FRHITexture&>(*Resource.ResourceRHI);
			const bool bZero = State.Observer && State.Observer->OnTextureMade(Texture);
			if (bZero || bReuse || (State.Observer && State.Observer->WantsZeroedTextures()))
			{
				ZeroTexture(Texture);
			}
		}
		else if (State.Observer || bReuse)
		{
			ZeroBuffer(static_cast<FRHIBuffer&>(*Resource.ResourceRHI));
		}
		return;
	}
	if (Resource.Type == ERDGViewableResourceType::Texture)
	{
		ClobberTexture(static_cast<FRHITexture&>(*Resource.ResourceRHI), State.Settings.ClobberResources);
	}
	else
	{
		ClobberBuffer(static_cast<FRHIBuffer&>(*Resource.ResourceRHI), State.Settings.ClobberResources);
	}
}

void FRDGExecutor::Upload(FRDGBuffer& Buffer)
{
	auto& RHIBuffer = static_cast<FRHIBuffer&>(*Buffer.ResourceRHI);
	const FRDGUpload& Upload = State.Uploads[&Buffer];
	uint8* const Data = RHIBuffer.GetData();
	std::memcpy(Data, Upload.Data, Upload.Size);
	std::memset(Data + Upload.Size, 0, RHIBuffer.GetSize() - Upload.Size);
}

// Passes ------------------------------------------------------------------------------------------------------------

void FRDGExecutor::AllowAccess(const FRDGPassResources& Resources, bool bAllow)
{
	for (FRDGViewableResource* Resource : Resources.Viewables)
	{
		Resource->bAllowRHIAccess = bAllow || Resource->bExternalAccessNow;
	}
	for (FRDGView* View : Resources.Views)
	{
		View->bAllowRHIAccess = bAllow;
	}
	for (FRDGUniformBuffer* Buffer : Resources.UniformBuffers)
	{
		Buffer->bAllowRHIAccess = bAllow;
	}
}

/** Gives what the pass declares its memory and views. */
void FRDGExecutor::MakeReady(const FRDGPassResources& Resources)
{
	for (FRDGViewableResource* Resource : Resources.Viewables)
	{
		MakeReady(*Resource);
		Resource->bUsed = false;
	}
	for (FRDGView* View : Resources.Views)
	{
		if (!View->HasRHI())
		{
			View->ResourceRHI = View->CreateRHI();
		}
		View->bUsed = false;
	}
	for (FRDGUniformBuffer* Buffer : Resources.UniformBuffers)
	{
		if (!Buffer->HasRHI())
		{
			Buffer->ResourceRHI = CreateUniformBuffer(Buffer->GetMetadata(), Buffer->GetContents()).GetReference();
		}
	}
}

void FRDGExecutor::RunPass(FRDGPass& Pass)
{
	const FRDGPassResources& Resources = State.PassResources[size_t(Pass.GetIndex()) - 1];
	CallCode(Pass.GetOwner(), [&] { MakeReady(Resources); });

	struct FAccess
	{
		FAccess(FRDGExecutor& InExecutor, const FRDGPassResources& InResources)
			: Executor(InExecutor)
			, Resources(InResources)
		{
			Executor.AllowAccess(Resources, true);
		}
		~FAccess() { Executor.AllowAccess(Resources, false); }

		FRDGExecutor& Executor;
		const FRDGPassResources& Resources;
	} Access(*this, Resources);

	RHICmdList.ResetCounters();
	const auto Begin = std::chrono::steady_clock::now();
	CallCode(Pass.GetOwner(), [&] { RunLambda(Pass, Resources); });
	const std::chrono::duration<double, std::milli> Elapsed = std::chrono::steady_clock::now() - Begin;
	WarnAboutUnused(Pass, Resources);
	AddNewDiagnostics(State.Remarks, RHICmdList.TakeRemarks());
	if (State.Observer)
	{
		State.Observer->OnPassExecuted(
			Pass.GetIndex(), Pass, Elapsed.count(), RHICmdList.GetCounters(), FindWritten(Pass));
	}
}

/** A compiled graph has taken the descriptions over. */
const FRDGPassDescription& FRDGExecutor::Describe(const FRDGPass& Pass) const
{
	if (Compiled)
	{
		return Compiled->Passes[size_t(Pass.GetIndex())];
	}
	return State.GetDescription(Pass);
}

std::vector<FRDGTexture*> FRDGExecutor::FindWritten(const FRDGPass& Pass) const
{
	std::vector<FRDGTexture*> Written;
	for (const FRDGUse& Use : Describe(Pass).Uses)
	{
		FRDGViewableResource* const Resource = State.Resources[size_t(Use.Resource)].get();
		if (!Use.IsWrite() || Resource->Type != ERDGViewableResourceType::Texture)
		{
			continue;
		}
		auto* const Texture = static_cast<FRDGTexture*>(Resource);
		AddUnique(Written, Texture);
	}
	return Written;
}

void FRDGExecutor::WarnAboutUnused(const FRDGPass& Pass, const FRDGPassResources& Resources) const
{
	if (State.Settings.Debug == 0 || !State.Settings.bValidation || !PassesRDGPassFilter(Pass.GetName()))
	{
		return;
	}
	std::string Unused;
	size_t NumUnused = 0;
	for (const FRDGViewableResource* Resource : Resources.Viewables)
	{
		const bool bViewUsed = std::ranges::any_of(
			Resources.Views, [Resource](const FRDGView* View) { return View->GetParent() == Resource && View->bUsed; });
		if (!Resource->bUsed && !bViewUsed)
		{
			Unused += (NumUnused++ ? ", " : "") + std::string(Resource->Name);
		}
	}
	if (NumUnused > 0)
	{
		FDiagnostic Diagnostic;
		Diagnostic.Severity = ESeverity::Warning;
		Diagnostic.Code = RDGWarningUnusedParameter;
		Diagnostic.Message = std::to_string(NumUnused) + " of " + std::to_string(Resources.Viewables.size()) +
							 " resources of the pass were not actually used: " + Unused;
		Diagnostic.File = Pass.GetLocation().File;
		Diagnostic.Line = int(Pass.GetLocation().Line);
		Diagnostic.Where = std::string("pass ") + Pass.GetName();
		ReportRDGWarning(Diagnostic, State.Settings.Debug == 1);
	}
}

// The rest ----------------------------------------------------------------------------------------------------------

void FRDGExecutor::WriteExtractions()
{
	for (const auto& Extraction : State.TextureExtractions)
	{
		MakeReady(*Extraction.Resource); // an external texture that no pass touched
		*Extraction.Out = Extraction.Resource->PooledTexture;
	}
	for (const auto& Extraction : State.BufferExtractions)
	{
		MakeReady(*Extraction.Resource);
		*Extraction.Out = Extraction.Resource->PooledBuffer;
	}
}

void FRDGExecutor::LogTransitions(const FRDGCompiledGraph& InCompiled) const
{
	if (PassesRDGGraphFilter(InCompiled.Name.c_str()) && ConsumeRDGTransitionLog())
	{
		PrintText(stderr, DumpTransitions(InCompiled));
	}
}

void FRDGExecutor::SetExternalAccess(FRDGViewableResource& Resource, bool bExternal)
{
	Resource.bExternalAccessNow = bExternal;
}

} // namespace Drydock
