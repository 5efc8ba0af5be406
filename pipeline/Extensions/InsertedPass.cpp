// Makes a view extension of each pass that a config inserts.
#include "Extensions/InsertedPass.h"

#include "CodeScope.h"
#include "Extensions/ExtensionErrors.h"
#include "PostProcess/PostProcessing.h"
#include "SceneViewState.h"
#include "SystemTextures.h"

namespace Drydock
{

namespace
{

/** The part that the passes of both hooks share. */
class FPassInserter
{
public:
	FPassInserter(const FPassRequest& InRequest, std::shared_ptr<FPassResults> InResults)
		: Request(InRequest)
		, Results(std::move(InResults))
	{
	}

	const std::string& GetHook() const { return Request.Hook; }

	/** The picture from then on. */
	FScreenPassTexture Add(FRDGBuilder& GraphBuilder, const FViewInfo& View, const FScreenPassTexture& Picture)
	{
		const FPassFactory* Factory = FindPassFactory(Request.Type);
		check(Factory);
		FPassArguments Arguments;
		Arguments.Values = Request.Values;
		for (const auto& [Name, Resource] : Request.Resources)
		{
			Arguments.Inputs[Name] = Find(GraphBuilder, View, Picture, Resource);
		}
		const FScreenPassTexture Result = CallCode(Factory->Owner,
			[&]
			{
				const FScreenPassTexture Returned = Factory->Add(GraphBuilder, View, Arguments);
				GraphBuilder.CheckArgument(Returned.Texture, "what it returned", "Texture");
				return Returned;
			});
		(*Results)[{&View, Request.Name}] = Result;
		return Request.bReplace ? Result : Picture;
	}

private:
	FScreenPassTexture Find(FRDGBuilder& GraphBuilder, const FViewInfo& View, const FScreenPassTexture& Picture,
		const std::string& Resource) const
	{
		if (Resource == PictureResource)
		{
			return Picture;
		}
		if (Resource == CustomSSRInputName)
		{
			const FScreenPassTexture Last = View.ViewState != nullptr
												? View.ViewState->RegisterLastTexture(GraphBuilder, CustomSSRInputName)
												: FScreenPassTexture();
			return Last.IsValid() ? Last : FScreenPassTexture(GSystemTextures.GetBlackDummy(GraphBuilder));
		}
		const auto Found = Results->find({&View, Resource});
		if (Found != Results->end())
		{
			return Found->second;
		}
		const FSceneTextures& Scene = View.GetSceneTexturesChecked();
		const std::pair<const char*, FRDGTextureRef> Textures[] = {{"SceneDepth", Scene.Depth},
			{"Velocity", Scene.Velocity}, {"GBufferA", Scene.GBufferA}, {"GBufferB", Scene.GBufferB},
			{"GBufferC", Scene.GBufferC}, {"GBufferD", Scene.GBufferD}, {"CustomDepth", Scene.CustomDepth},
			{"ToonShadow", Scene.ToonShadow}};
		for (const auto& [Name, Texture] : Textures)
		{
			if (Resource == Name && Texture != nullptr)
			{
				return FScreenPassTexture(Texture, View.ViewRect);
			}
		}
		if (const FRDGTextureRef Named = Scene.FindNamed(Resource.c_str()))
		{
			return FScreenPassTexture(Named, View.ViewRect);
		}
		FDiagnostic Diagnostic;
		Diagnostic.Code = ErrorPassInput;
		Diagnostic.Where = "pass " + Request.Name + " at " + Request.Hook;
		Diagnostic.Message = "there is no " + Resource +
							 " at this point: the scene has none, or the pass that makes it comes later in the frame";
		throw FError(Diagnostic, ExitUsage);
	}

	FPassRequest Request;
	std::shared_ptr<FPassResults> Results;
};

class FInsertedAtPass : public FSceneViewExtensionBase
{
public:
	FInsertedAtPass(const FAutoRegister& AutoRegister, FPassInserter InInserter)
		: FSceneViewExtensionBase(AutoRegister)
		, Inserter(std::move(InInserter))
		, Hook(FindPassByName(Inserter.GetHook()))
	{
		check(Hook);
	}

	void SubscribeToPostProcessingPass(
		EPostProcessingPass Pass, FAfterPassCallbackDelegateArray& Callbacks, bool) override
	{
		if (Pass == *Hook)
		{
			Callbacks.Add(FAfterPassCallbackDelegate::CreateSP(this, &FInsertedAtPass::AddPass));
		}
	}

private:
	FScreenPassTexture AddPass(
		FRDGBuilder& GraphBuilder, const FSceneView& View, const FPostProcessMaterialInputs& Inputs)
	{
		const FScreenPassTexture Result = Inserter.Add(
			GraphBuilder, static_cast<const FViewInfo&>(View), Inputs.GetInput(EPostProcessMaterialInput::SceneColor));
		if (!Inputs.OverrideOutput.IsValid())
		{
			return Result;
		}
		AddDrawTexturePass(GraphBuilder, View, Result, Inputs.OverrideOutput);
		return Inputs.OverrideOutput;
	}

	FPassInserter Inserter;
	std::optional<EPostProcessingPass> Hook;
};

class FInsertedBefore : public FSceneViewExtensionBase
{
public:
	FInsertedBefore(const FAutoRegister& AutoRegister, FPassInserter InInserter)
		: FSceneViewExtensionBase(AutoRegister)
		, Inserter(std::move(InInserter))
	{
	}

	void PrePostProcessPass_RenderThread(
		FRDGBuilder& GraphBuilder, const FSceneView& View, const FPostProcessingInputs& Inputs) override
	{
		const FViewInfo& ViewInfo = static_cast<const FViewInfo&>(View);
		const FScreenPassTexture Picture((*Inputs.SceneTextures)->SceneColorTexture, ViewInfo.ViewRect);
		const FScreenPassTexture Result = Inserter.Add(GraphBuilder, ViewInfo, Picture);
		if (Result.Texture != Picture.Texture)
		{
			AddDrawTexturePass(
				GraphBuilder, View, Result, FScreenPassRenderTarget(Picture, ERenderTargetLoadAction::ELoad));
		}
	}

private:
	FPassInserter Inserter;
};

template<typename TExtension>
TSharedRef<ISceneViewExtension, ESPMode::ThreadSafe> Create(
	const FPassRequest& Request, const std::shared_ptr<FPassResults>& Results)
{
	return FSceneViewExtensions::NewExtension<TExtension>(FPassInserter(Request, Results));
}

} // namespace

TSharedRef<ISceneViewExtension, ESPMode::ThreadSafe> CreateInsertedPass(
	const FPassRequest& Request, const std::shared_ptr<FPassResults>& Results)
{
	return Request.Hook == PrePostProcessPassName ? Create<FInsertedBefore>(Request, Results)
												  : Create<FInsertedAtPass>(Request, Results);
}

} // namespace Drydock
