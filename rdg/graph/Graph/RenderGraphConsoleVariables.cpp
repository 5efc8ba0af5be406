// Registers the r.RDG.* console variables; names, defaults and meanings are the engine's.
#include "RenderGraphConsoleVariables.h"

#include <cstring>

namespace
{

TAutoConsoleVariable<int32> CVarImmediateMode(TEXT("r.RDG.ImmediateMode"), 0,
	TEXT("Runs each pass inside AddPass: nothing is culled, merged or aliased, and a fault shows where it was "
		 "declared."),
	ECVF_RenderThreadSafe);
TAutoConsoleVariable<int32> CVarValidation(TEXT("r.RDG.Validation"), 1,
	TEXT("Checks the graph: 0 off, 1 on (default), 2 also ends the run for what is undefined, where 1 warns."),
	ECVF_RenderThreadSafe);
TAutoConsoleVariable<int32> CVarDebug(TEXT("r.RDG.Debug"), 0,
	TEXT("Warns about waste: 0 off (default), 1 once per message, 2 always."), ECVF_RenderThreadSafe);
TAutoConsoleVariable<int32> CVarFlushGPU(TEXT("r.RDG.Debug.FlushGPU"), 0,
	TEXT("Waits after each pass. Passes always run one after the other here: turns async compute off, nothing else."),
	ECVF_RenderThreadSafe);
TAutoConsoleVariable<int32> CVarExtendLifetimes(TEXT("r.RDG.Debug.ExtendResourceLifetimes"), 0,
	TEXT("Keeps every resource for the whole graph, so that none shares memory: 0 off (default), 1 on."),
	ECVF_RenderThreadSafe);
TAutoConsoleVariable<int32> CVarDisableTransient(TEXT("r.RDG.Debug.DisableTransientResources"), 0,
	TEXT("Gives every resource memory of its own: 0 off (default), 1 on."), ECVF_RenderThreadSafe);
TAutoConsoleVariable<FString> CVarGraphFilter(TEXT("r.RDG.Debug.GraphFilter"), FString(),
	TEXT("Debugging acts on graphs whose name contains this; !text inverts, None resets."), ECVF_RenderThreadSafe);
TAutoConsoleVariable<FString> CVarPassFilter(TEXT("r.RDG.Debug.PassFilter"), FString(),
	TEXT("Debugging acts on passes whose name contains this; !text inverts, None resets."), ECVF_RenderThreadSafe);
TAutoConsoleVariable<FString> CVarResourceFilter(TEXT("r.RDG.Debug.ResourceFilter"), FString(),
	TEXT("Debugging acts on resources whose name contains this; !text inverts, None resets."), ECVF_RenderThreadSafe);
TAutoConsoleVariable<int32> CVarClobber(TEXT("r.RDG.ClobberResources"), 0,
	TEXT("Fills new resources before their first use: 0 off (default), 1 with 1000, 2 with NaN, 3 with +Inf."),
	ECVF_RenderThreadSafe);
TAutoConsoleVariable<int32> CVarOverlapUAVs(TEXT("r.RDG.OverlapUAVs"), 1,
	TEXT("Honours SkipBarrier views when transitions are computed."), ECVF_RenderThreadSafe);
TAutoConsoleVariable<int32> CVarTransitionLog(TEXT("r.RDG.TransitionLog"), 0,
	TEXT("Logs the transitions of that many graphs; below 0 of all."), ECVF_RenderThreadSafe);
TAutoConsoleVariable<int32> CVarAsyncCompute(TEXT("r.RDG.AsyncCompute"), 1,
	TEXT("Which passes count as async compute: 0 none, 1 those tagged (default), 2 all compute passes. Recorded only."),
	ECVF_RenderThreadSafe);
TAutoConsoleVariable<int32> CVarCullPasses(TEXT("r.RDG.CullPasses"), 1,
	TEXT("Leaves out passes that no output needs: 0 off, 1 on (default)."), ECVF_RenderThreadSafe);
TAutoConsoleVariable<int32> CVarMergeRenderPasses(TEXT("r.RDG.MergeRenderPasses"), 1,
	TEXT("Merges neighbouring raster passes with the same targets: 0 off, 1 on (default). Recorded only."),
	ECVF_RenderThreadSafe);
TAutoConsoleVariable<int32> CVarTransientAllocator(TEXT("r.RDG.TransientAllocator"), 1,
	TEXT("Lets resources share the graph's heap: 0 off, 1 on (default), 2 only those with FastVRAM."),
	ECVF_RenderThreadSafe);
TAutoConsoleVariable<int32> CVarTransientIndirect(TEXT("r.RDG.TransientAllocator.IndirectArgumentBuffers"), 0,
	TEXT("Lets buffers of indirect arguments live in the heap: 0 off (default), 1 on."), ECVF_RenderThreadSafe);
TAutoConsoleVariable<int32> CVarEvents(TEXT("r.RDG.Events"), 1,
	TEXT("Records event scopes: 0 off, 1 on (default), 2 on, also inside final scopes."), ECVF_RenderThreadSafe);

/** Those that the engine has and nothing here reads. */
const FAutoConsoleVariable NotRead[] = {
	{TEXT("r.RDG.Breakpoint"), 0, TEXT("Breaks into a debugger in the engine; without effect here."),
		ECVF_RenderThreadSafe},
	{TEXT("r.RDG.TransientExtractedResources"), 1,
		TEXT("Extracted resources outlive the heap of a graph here, so they always have memory of their own."),
		ECVF_RenderThreadSafe},
	{TEXT("r.RDG.ParallelDestruction"), 1, TEXT("Without effect here."), ECVF_RenderThreadSafe},
	{TEXT("r.RDG.ParallelSetup"), 1, TEXT("Without effect here."), ECVF_RenderThreadSafe},
	{TEXT("r.RDG.ParallelExecute"), 1,
		TEXT("Without effect here: passes run in turn, each over all threads (r.Drydock.Threads)."),
		ECVF_RenderThreadSafe},
	{TEXT("r.RDG.ParallelExecute.PassMin"), 1, TEXT("Without effect here."), ECVF_RenderThreadSafe},
	{TEXT("r.RDG.ParallelExecute.PassMax"), 32, TEXT("Without effect here."), ECVF_RenderThreadSafe},
	{TEXT("r.RDG.ParallelExecuteStress"), 0, TEXT("Without effect here."), ECVF_RenderThreadSafe},
	{TEXT("r.RDG.VerboseCSVStats"), 0, TEXT("Without effect here."), ECVF_RenderThreadSafe},
};

bool PassesFilter(const FString& Filter, const TCHAR* Name)
{
	if (Filter.IsEmpty() || Filter == TEXT("None"))
	{
		return true;
	}
	const TCHAR* const Text = *Filter;
	return Text[0] == '!' ? std::strstr(Name, Text + 1) == nullptr : std::strstr(Name, Text) != nullptr;
}

} // namespace

namespace Drydock
{

FRDGSettings GetRDGSettings()
{
	FRDGSettings Settings;
	Settings.bImmediateMode = CVarImmediateMode.GetValueOnAnyThread() != 0;
	Settings.bValidation = CVarValidation.GetValueOnAnyThread() != 0;
	Settings.bStrictValidation = CVarValidation.GetValueOnAnyThread() >= 2;
	Settings.Debug = CVarDebug.GetValueOnAnyThread();
	Settings.bExtendResourceLifetimes = CVarExtendLifetimes.GetValueOnAnyThread() != 0;
	Settings.bDisableTransientResources = CVarDisableTransient.GetValueOnAnyThread() != 0;
	Settings.ClobberResources = CVarClobber.GetValueOnAnyThread();
	Settings.bOverlapUAVs = CVarOverlapUAVs.GetValueOnAnyThread() != 0;
	Settings.AsyncCompute =
		CVarFlushGPU.GetValueOnAnyThread() != 0 || Settings.bImmediateMode ? 0 : CVarAsyncCompute.GetValueOnAnyThread();
	Settings.bCullPasses = CVarCullPasses.GetValueOnAnyThread() != 0;
	Settings.bMergeRenderPasses = CVarMergeRenderPasses.GetValueOnAnyThread() != 0;
	Settings.TransientAllocator = CVarTransientAllocator.GetValueOnAnyThread();
	Settings.bTransientIndirectArguments = CVarTransientIndirect.GetValueOnAnyThread() != 0;
	Settings.Events = CVarEvents.GetValueOnAnyThread();
	return Settings;
}

bool ConsumeRDGTransitionLog()
{
	const int32 Left = CVarTransitionLog.GetValueOnAnyThread();
	if (Left > 0)
	{
		CVarTransitionLog->SetWithCurrentPriority(Left - 1);
	}
	return Left != 0;
}

bool PassesRDGGraphFilter(const TCHAR* Name)
{
	return PassesFilter(CVarGraphFilter.GetValueOnAnyThread(), Name);
}

bool PassesRDGPassFilter(const TCHAR* Name)
{
	return PassesFilter(CVarPassFilter.GetValueOnAnyThread(), Name);
}

bool PassesRDGResourceFilter(const TCHAR* Name)
{
	return PassesFilter(CVarResourceFilter.GetValueOnAnyThread(), Name);
}

} // namespace Drydock
