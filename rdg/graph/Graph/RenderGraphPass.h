// A pass: its name, flags, parameters and the lambda that does its work. Source: engine RenderGraphPass.h.
#pragma once

#include "RHICommandList.h"
#include "RenderGraphDefinitions.h"
#include "RenderGraphEvent.h"
#include "RunningCode.h"
#include "SourceLocation.h"

#include <string>
#include <type_traits>

class FShader;
class FShaderParametersMetadata;

/** Tag argument of lambdas that may run on any thread (5.4 and newer). */
struct FRDGAsyncTask
{
};

class DRYDOCK_API FRDGPass
{
public:
	virtual ~FRDGPass();
	FRDGPass(const FRDGPass&) = delete;
	FRDGPass& operator=(const FRDGPass&) = delete;

	const TCHAR* GetName() const { return Name.GetTCHAR(); }
	const TCHAR* GetEventName() const { return GetName(); }
	ERDGPassFlags GetFlags() const { return Flags; }
	ERHIPipeline GetPipeline() const { return GetPassPipeline(Flags); }

	/** Names of the open scopes, outermost first, joined by '/'. */
	const std::string& GetScope() const { return Scope; }

	/** Position in FRDGCompiledGraph::Passes: the prologue is 0, the first pass 1. */
	int32 GetIndex() const { return Index; }

	/** The place in the source that called AddPass. */
	const Drydock::FSourceLocation& GetLocation() const { return Location; }

	/** Null for a pass without parameters. */
	const FShaderParametersMetadata* GetParametersMetadata() const { return Metadata; }
	const void* GetParameters() const { return Parameters; }

	/** Tells which shader the pass runs: for listings made without executing, and so that it is compiled before the
	 * graph's first pass runs. */
	void SetShader(FShader& InShader);
	/** The same of a vertex shader that its draws run. */
	void SetVertexShader(FShader& InShader) { VertexShaderToCompile = &InShader; }
	const std::string& GetShader() const { return Shader; }
	const std::string& GetEntry() const { return Entry; }
	/** Describes how the pass's shaders are going to run, by DescribeShaderRun; reads the files of shaders that have a
	 * hand-written kernel. Empty: the pass names no shader. */
	std::string DescribeRun() const;

	/** The effect that the pass belongs to, by the innermost FRDGEffectScope; empty: none. */
	const std::string& GetEffect() const { return Effect; }

	/** Pixels that it draws, where whoever added it knows; else 0. */
	void SetArea(FIntPoint InArea) { Area = InArea; }
	FIntPoint GetArea() const { return Area; }

	/** The owner of the code that added the pass, and so of its lambda. */
	const Drydock::FCodeOwner& GetOwner() const { return Owner; }

	/** Known once compiled. */
	bool IsCulled() const { return bCulled; }

protected:
	FRDGPass(FRDGEventName&& InName, const FShaderParametersMetadata* InMetadata, const void* InParameters,
		ERDGPassFlags InFlags, const Drydock::FSourceLocation& InLocation)
		: Name(MoveTemp(InName))
		, Metadata(InMetadata)
		, Parameters(InParameters)
		, Flags(InFlags)
		, Location(InLocation)
	{
	}

private:
	friend class FRDGBuilder;
	friend class Drydock::FRDGExecutor;

	virtual void Execute(FRHICommandListImmediate& RHICmdList) = 0;

	FRDGEventName Name;
	const FShaderParametersMetadata* Metadata;
	const void* Parameters;
	ERDGPassFlags Flags;
	Drydock::FSourceLocation Location;
	std::string Scope;
	std::string Effect;
	Drydock::FCodeOwner Owner;
	FIntPoint Area = FIntPoint(0, 0);
	std::string Shader;
	std::string Entry;
	FShader* ShaderToCompile = nullptr;
	FShader* VertexShaderToCompile = nullptr;
	int32 Index = -1;
	uint32 Workload = 1;
	bool bCulled = false;
};

/** A pass that is a lambda. The lambda is kept until Execute: capture by value, and graph resources by pointer. */
template<typename LambdaType>
class TRDGLambdaPass final : public FRDGPass
{
public:
	TRDGLambdaPass(FRDGEventName&& InName, const FShaderParametersMetadata* InMetadata, const void* InParameters,
		ERDGPassFlags InFlags, LambdaType&& InLambda, const Drydock::FSourceLocation& InLocation)
		: FRDGPass(MoveTemp(InName), InMetadata, InParameters, InFlags, InLocation)
		, Lambda(std::move(InLambda))
	{
	}

private:
	void Execute(FRHICommandListImmediate& RHICmdList) override
	{
		// The immediate list is every other kind of list as well.
		if constexpr (std::is_invocable_v<LambdaType&, FRHICommandListImmediate&>)
		{
			Lambda(RHICmdList);
		}
		else if constexpr (std::is_invocable_v<LambdaType&, FRDGAsyncTask, FRHICommandListImmediate&>)
		{
			Lambda(FRDGAsyncTask(), RHICmdList);
		}
		else if constexpr (std::is_invocable_v<LambdaType&, const FRDGPass*, FRHICommandListImmediate&>)
		{
			Lambda(this, RHICmdList);
		}
		else
		{
			static_assert(sizeof(LambdaType) == 0,
				"a pass's lambda takes FRHIComputeCommandList&, FRHICommandList& or FRHICommandListImmediate&");
		}
	}

	LambdaType Lambda;
};
