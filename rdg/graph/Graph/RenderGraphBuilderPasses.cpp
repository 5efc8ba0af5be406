// Takes in the builder's passes and scopes, and does what happens at the end. Behaviour is the engine's.
#include "RenderGraphBuilder.h"

#include "CodeScope.h"
#include "DiagnosticList.h"
#include "HAL/IConsoleManager.h"
#include "NativeKernels.h"
#include "RenderGraphCompile.h"
#include "RenderGraphExecute.h"
#include "RenderGraphNotes.h"
#include "RenderGraphObserver.h"
#include "RenderGraphReport.h"
#include "RenderGraphState.h"
#include "Shader.h"
#include "RenderGraphValidate.h"

#include <pthread.h>

using namespace Drydock;

FRDGPass::~FRDGPass() = default;

void FRDGPass::SetShader(FShader& InShader)
{
	ShaderToCompile = &InShader;
	Shader = InShader.GetType()->GetName();
	Entry = InShader.GetType()->GetFunctionName();
}

std::string FRDGPass::DescribeRun() const
{
	if (!ShaderToCompile)
	{
		return {};
	}
	const IConsoleVariable* const Backend = IConsoleManager::Get().FindConsoleVariable(TEXT("r.Drydock.Backend"));
	const EShaderRun Vertex = VertexShaderToCompile ? EShaderRun::Interpreter : EShaderRun::None;
	const EShaderRun Pixel = FindNativeKernel(FShaderRef(ShaderToCompile)) == ENativeChoice::Native
								 ? EShaderRun::NativeKernel
							 : Backend && Backend->GetInt() != 0 ? EShaderRun::Backend
																 : EShaderRun::Shader;
	return DescribeShaderRun(Pixel | Vertex);
}

namespace
{

FRDGPassDescription DescribePass(const FRDGPass& Pass, const FRDGSettings& Settings)
{
	FRDGPassDescription Description;
	Description.Index = Pass.GetIndex();
	Description.Name = Pass.GetName();
	Description.Scope = Pass.GetScope();
	Description.Effect = Pass.GetEffect();
	if (Pass.GetOwner().IsForeign())
	{
		Description.Owner = FCodeOwner{Pass.GetOwner().Plugin, Pass.GetOwner().Callback}.Describe();
	}
	Description.Flags = Pass.GetFlags();
	Description.File = Pass.GetLocation().File;
	Description.Line = int32(Pass.GetLocation().Line);
	Description.bHasParameters = Pass.GetParametersMetadata() != nullptr;
	const ERDGPassFlags Async =
		Settings.AsyncCompute == 2 ? ERDGPassFlags::AsyncCompute | ERDGPassFlags::Compute : ERDGPassFlags::AsyncCompute;
	const bool bGraphicsWork = EnumHasAnyFlags(Pass.GetFlags(), ERDGPassFlags::Raster | ERDGPassFlags::Copy);
	Description.bAsync = Settings.AsyncCompute != 0 && EnumHasAnyFlags(Pass.GetFlags(), Async) && !bGraphicsWork;
	return Description;
}

/** Whether this thread's stack holds the object, in a function that has not returned yet. */
bool LiesOnStack(const void* Object)
{
	thread_local const uintptr_t End = []
	{
		pthread_attr_t Attributes;
		void* Low = nullptr;
		size_t Size = 0;
		if (pthread_getattr_np(pthread_self(), &Attributes) == 0)
		{
			pthread_attr_getstack(&Attributes, &Low, &Size);
			pthread_attr_destroy(&Attributes);
		}
		return reinterpret_cast<uintptr_t>(Low) + Size;
	}();
	const auto At = reinterpret_cast<uintptr_t>(Object);
	return At >= reinterpret_cast<uintptr_t>(__builtin_frame_address(0)) && At < End;
}

} // namespace

FRDGPassRef FRDGBuilder::AdoptPass(FRDGPass* Pass)
{
	TRDGPlaced<FRDGPass> Placed(Pass);
	RequireOpen("AddPass");
	try
	{
		DeclarePass(*Pass);
		State->Passes.push_back(MoveTemp(Placed));
		State->Known.Add(Pass, ERDGObject::Pass);
		if (State->Settings.bImmediateMode)
		{
			ResolveBufferSizes();
			// Those before it were found right when they were added.
			ThrowCollectedErrors(
				ValidatePass(State->Graph, State->Graph.Passes.back(), State->Settings.bStrictValidation));
			FRDGExecutor(*State, RHICmdList).RunPassImmediately(*Pass);
		}
	}
	catch (...)
	{
		State->bFailed = true;
		throw;
	}
	return Pass;
}

void FRDGBuilder::DeclarePass(FRDGPass& Pass)
{
	Pass.Index = int32(State->Graph.Passes.size());
	if (!State->Scopes.empty())
	{
		Pass.Scope = State->Scopes.back().Path;
		Pass.Effect = State->Scopes.back().Effect;
	}

	if (const FCodeOwner* const Running = GetRunningCode())
	{
		Pass.Owner = {Running->Plugin, Running->IsForeign() ? Running->Callback : ""};
	}
	Pass.Owner.Pass = Pass.GetName();
	Pass.Owner.File = Pass.Location.File;
	Pass.Owner.Line = int(Pass.Location.Line);
	FRDGPassDescription Description = DescribePass(Pass, State->Settings);
	if (Pass.Metadata && !Pass.Parameters)
	{
		ThrowRDGErrors({MakePassDiagnostic(
			ESeverity::Error, RDGErrorNullArgument, Description, "the pass was added with null parameters")});
	}
	if (Pass.Owner.IsForeign() && LiesOnStack(Pass.Parameters))
	{
		ThrowRDGErrors({MakePassDiagnostic(ESeverity::Error, RDGErrorStackParameters, Description,
			"the parameters lie on the stack of " + Pass.Owner.Callback +
				", and are gone when the pass runs: take them from GraphBuilder.AllocParameters<" +
				(Pass.Metadata ? Pass.Metadata->GetStructTypeName() : "FParameters") + ">()")});
	}
	FRDGPassResources Resources;
	if (Pass.Metadata)
	{
		Resources = CollectPassResources(
			*Pass.Metadata, Pass.Parameters,
			[this](const void* Pointer, ERDGObject Kinds) { return State->Known.Has(Pointer, Kinds); }, Description);
	}
	for (const FRDGUse& Use : Description.Uses)
	{
		FRDGViewableResource& Resource = *State->Resources[size_t(Use.Resource)];
		Resource.bProduced = Resource.bProduced || Use.IsWrite();
		if (Resource.ExternalAccess != ERHIAccess::Unknown &&
			EnumHasAnyFlags(Use.Access, ~(Resource.ExternalAccess | ERHIAccess::SRVMask)))
		{
			State->Ensures.push_back(MakePassDiagnostic(ESeverity::Warning, RDGEnsureExternalAccess, Description,
				std::string("the resource is in external access mode (") + *GetRHIAccessName(Resource.ExternalAccess) +
					") but is accessed as " + *GetRHIAccessName(Use.Access),
				Use.Parameter, Resource.Name));
		}
	}
	State->Graph.Passes.push_back(MoveTemp(Description));
	State->PassResources.push_back(MoveTemp(Resources));
}

void FRDGBuilder::AddPassDependency(FRDGPassRef Producer, FRDGPassRef Consumer)
{
	RequireOpen("AddPassDependency");
	CheckArgument(Producer, "AddPassDependency", "Producer");
	CheckArgument(Consumer, "AddPassDependency", "Consumer");
	if (Producer->GetIndex() >= Consumer->GetIndex())
	{
		State->Errors.push_back(
			MakePassDiagnostic(ESeverity::Error, RDGErrorPassDependency, State->GetDescription(*Consumer),
				std::string("the pass cannot depend on ") + Producer->GetName() + ", which is not added before it"));
		return;
	}
	State->GetDescription(*Consumer).DeclaredProducers.push_back(Producer->GetIndex());
}

void FRDGBuilder::SetPassWorkload(FRDGPassRef Pass, uint32 Workload)
{
	RequireOpen("SetPassWorkload");
	CheckArgument(Pass, "SetPassWorkload", "Pass");
	Pass->Workload = Workload;
	State->GetDescription(*Pass).Workload = Workload;
}

// Scopes ------------------------------------------------------------------------------------------------------------

void FRDGBuilder::OpenScope(const FRDGEventName& ScopeName, bool bFinal)
{
	FRDGScope Scope;
	const FRDGScope* const Outer = State->Scopes.empty() ? nullptr : &State->Scopes.back();
	const bool bInsideFinal = Outer && Outer->bFinal && State->Settings.Events != 2;
	Scope.bRecorded = State->Settings.Events != 0 && !bInsideFinal;
	Scope.bFinal = bFinal || (Outer && Outer->bFinal);
	Scope.Path = Outer ? Outer->Path : "";
	Scope.Effect = Outer ? Outer->Effect : "";
	if (Scope.bRecorded)
	{
		Scope.Path += (Scope.Path.empty() ? "" : "/") + std::string(ScopeName.GetTCHAR());
	}
	State->Scopes.push_back(MoveTemp(Scope));
}

void FRDGBuilder::BeginEventScope(FRDGEventName&& ScopeName)
{
	OpenScope(ScopeName, false);
}

void FRDGBuilder::BeginFinalEventScope(FRDGEventName&& ScopeName)
{
	OpenScope(ScopeName, true);
}

void FRDGBuilder::BeginEffectScope(const char* Effect)
{
	FRDGScope Scope = State->Scopes.empty() ? FRDGScope() : State->Scopes.back();
	Scope.Effect = Effect;
	State->Scopes.push_back(MoveTemp(Scope));
}

void FRDGBuilder::EndEventScope()
{
	if (State->Scopes.empty())
	{
		Fail(RDGErrorScope, "EndEventScope was called without BeginEventScope", "graph " + State->Graph.Name);
	}
	State->Scopes.pop_back();
}

FRDGEventScopeGuard::FRDGEventScopeGuard(
	FRDGBuilder& InGraphBuilder, FRDGEventName&& ScopeName, bool bCondition, bool bFinal)
	: GraphBuilder(InGraphBuilder)
	, bOpened(bCondition)
{
	if (bOpened && bFinal)
	{
		GraphBuilder.BeginFinalEventScope(MoveTemp(ScopeName));
	}
	else if (bOpened)
	{
		GraphBuilder.BeginEventScope(MoveTemp(ScopeName));
	}
}

FRDGEventScopeGuard::~FRDGEventScopeGuard()
{
	if (bOpened)
	{
		GraphBuilder.EndEventScope();
	}
}

Drydock::FRDGEffectScope::FRDGEffectScope(FRDGBuilder& InGraphBuilder, const char* Effect)
	: GraphBuilder(InGraphBuilder)
{
	GraphBuilder.BeginEffectScope(Effect != nullptr ? Effect : "");
}

Drydock::FRDGEffectScope::~FRDGEffectScope()
{
	GraphBuilder.EndEventScope();
}

// The end -----------------------------------------------------------------------------------------------------------

void FRDGBuilder::ThrowCollectedErrors(const std::vector<FDiagnostic>& GraphErrors)
{
	if (!State->Settings.bValidation)
	{
		return;
	}
	std::vector<FDiagnostic> Errors = State->Errors;
	Errors.insert(Errors.end(), GraphErrors.begin(), GraphErrors.end());
	if (!Errors.empty())
	{
		State->bFinished = true;
		ThrowRDGErrors(Errors);
	}
}

/** Throws the graph's errors and tells the rest; returns the warnings. */
std::vector<FDiagnostic> FRDGBuilder::CheckGraph()
{
	if (!State->Settings.bValidation)
	{
		return {};
	}
	FRDGValidationResult Validation =
		ValidateGraph(State->Graph, State->Settings.Debug != 0, State->Settings.bStrictValidation);
	Validation.Ensures.insert(Validation.Ensures.begin(), State->Ensures.begin(), State->Ensures.end());
	ThrowCollectedErrors(Validation.Errors);
	if (!State->bEnsuresReported && !(State->Observer && State->Observer->ShowsWarnings()))
	{
		State->bEnsuresReported = true;
		for (const FDiagnostic& Diagnostic : SummarizeDiagnostics(Validation.Ensures))
		{
			ReportRDGEnsure(Diagnostic);
		}
		for (const FDiagnostic& Diagnostic : SummarizeDiagnostics(Validation.Warnings))
		{
			ReportRDGWarning(Diagnostic, State->Settings.Debug == 1 && IsRDGWarningOfWaste(Diagnostic.Code));
		}
	}
	std::vector<FDiagnostic> Warnings = MoveTemp(Validation.Ensures);
	Warnings.insert(Warnings.end(), Validation.Warnings.begin(), Validation.Warnings.end());
	return Warnings;
}

/** Compiles a checked graph, with what its passes reported since they were added, and with the epilogue. */
FRDGCompiledGraph FRDGBuilder::Compile(FRDGGraphDescription Graph)
{
	for (const TRDGPlaced<FRDGPass>& Pass : State->Passes)
	{
		FRDGPassDescription& Description = Graph.Passes[size_t(Pass->GetIndex())];
		Description.Shader = Pass->GetShader();
		Description.Entry = Pass->GetEntry();
		Description.Area = Pass->GetArea();
	}
	FRDGPassDescription& Epilogue = Graph.Passes.emplace_back();
	Epilogue.Index = int32(Graph.Passes.size()) - 1;
	Epilogue.Name = "Graph Epilogue";
	Epilogue.bIsSentinel = true;
	return CompileGraph(MoveTemp(Graph), FRDGCompileOptions::FromConsoleVariables());
}

FRDGCompiledGraph FRDGBuilder::Compile()
{
	if (State->Graph.Passes.empty())
	{
		Fail(RDGErrorAfterExecute, "Compile was called after Execute", "graph " + State->Graph.Name);
	}
	ResolveBufferSizes();
	std::vector<FDiagnostic> Warnings = CheckGraph();
	FRDGCompiledGraph Compiled = Compile(State->Graph);
	Compiled.Warnings = MoveTemp(Warnings);
	for (const TRDGPlaced<FRDGPass>& Pass : State->Passes)
	{
		Compiled.Passes[size_t(Pass->GetIndex())].RunsAs = Pass->DescribeRun();
	}
	return Compiled;
}

void FRDGBuilder::Execute()
{
	if (State->bFinished)
	{
		Fail(RDGErrorExecutedTwice, "Execute was called on a graph that was executed or discarded before",
			"graph " + State->Graph.Name);
	}
	ResolveBufferSizes();
	std::vector<FDiagnostic> Warnings = CheckGraph();
	State->bFinished = true;
	// Nothing is added any more: the descriptions move into the compiled graph. The name stays for messages.
	FRDGGraphDescription Graph = MoveTemp(State->Graph);
	State->Graph.Name = Graph.Name;
	State->Compiled = std::make_unique<FRDGCompiledGraph>(Compile(MoveTemp(Graph)));
	State->Compiled->Warnings = MoveTemp(Warnings);
	FRDGExecutor Executor(*State, RHICmdList);
	if (State->Settings.bImmediateMode)
	{
		Executor.FinishImmediate(*State->Compiled);
	}
	else
	{
		Executor.RunGraph(*State->Compiled);
	}
	for (const FDiagnostic& Remark : State->Remarks)
	{
		AddGraphNote(*this, Remark);
	}
}
