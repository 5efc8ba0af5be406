// A plugin that goes wrong in whatever way and place the environment variable DRYDOCK_TEST_CRASH names ("KIND at
// PLACE"), and if DRYDOCK_TEST_CRASH_IF names a console variable, while that is not 0: PluginCrashTest.cpp and
// LiveCrashTest.cpp run the program with it.
#include "HAL/IConsoleManager.h"
#include "Modules/ModuleManager.h"
#include "PostProcess/PostProcessing.h"
#include "RenderTargetPool.h"
#include "TileExecutor.h"

#include <csignal>
#include <cstdlib>
#include <cstring>
#include <mutex>
#include <stdexcept>
#include <string>
#include <unwind.h>

namespace
{

bool Is(const char* Wanted, const char* Text)
{
	return std::strcmp(Wanted, Text) == 0;
}

int Overflow(int Depth) // NOLINT: without an end
{
	volatile char Frame[512] = {};
	Frame[0] = char(Depth);
	return Overflow(Depth + 1) + Frame[0];
}

void Throw(const char* What)
{
	throw std::runtime_error(What);
}

void LetOut() noexcept
{
	Throw("nobody may see this");
}

void RaiseForeign()
{
	static _Unwind_Exception Exception;
	Exception = {};
	std::memcpy(&Exception.exception_class, "DRYDTEST", 8);
	_Unwind_RaiseException(&Exception);
}

void Crash(const char* Kind)
{
	if (Is("write", Kind))
	{
		volatile int* volatile Nowhere = reinterpret_cast<int*>(8);
		*Nowhere = 1; // crash: write
	}
	else if (Is("header", Kind))
	{
		// A pointer that is none, read by drydock's code.
		const TArray<int32>* volatile Nothing = reinterpret_cast<const TArray<int32>*>(8);
		volatile int32 Num = Nothing->Num(); // crash: header
		Num = Num + 1;
	}
	else if (Is("library", Kind))
	{
		const TCHAR* volatile Nothing = reinterpret_cast<const TCHAR*>(8);
		volatile bool bFound = IConsoleManager::Get().FindConsoleVariable(Nothing) != nullptr; // crash: library
		bFound = !bFound;
	}
	else if (Is("nowhere", Kind))
	{
		void (*volatile Function)() = nullptr;
		volatile int NumCalls = 0;
		Function(); // crash: nowhere
		NumCalls = NumCalls + 1;
	}
	else if (Is("divide", Kind))
	{
#if defined(__x86_64__)
		volatile int Zero = 0;
		Zero = 100 / Zero;
#else
		raise(SIGFPE);
#endif
	}
	else if (Is("bus", Kind))
	{
		raise(SIGBUS);
	}
	else if (Is("trap", Kind))
	{
		raise(SIGILL);
	}
	else if (Is("abort", Kind))
	{
		std::abort();
	}
	else if (Is("overflow", Kind))
	{
		std::exit(Overflow(0));
	}
	else if (Is("exception", Kind))
	{
		Throw("the cup is empty");
	}
	else if (Is("int", Kind))
	{
		throw 7;
	}
	else if (Is("foreign", Kind))
	{
		RaiseForeign();
	}
	else if (Is("noexcept", Kind))
	{
		LetOut();
	}
	else if (Is("terminate", Kind))
	{
		std::terminate();
	}
	else if (Is("exit", Kind))
	{
		std::exit(0);
	}
	else if (Is("check", Kind))
	{
		checkf(Kind == nullptr, TEXT("a check of its own"));
	}
	else if (Is("deadlock", Kind))
	{
		static std::mutex Mutex;
		Mutex.lock();
		Mutex.lock();
	}
}

void CrashAt(const char* Place)
{
	const char* const Wanted = std::getenv("DRYDOCK_TEST_CRASH");
	const char* const Only = std::getenv("DRYDOCK_TEST_CRASH_IF"); // a console variable that is not 0
	if (Only != nullptr && IConsoleManager::Get().FindConsoleVariable(Only)->GetInt() == 0)
	{
		return;
	}
	const std::string Text = Wanted != nullptr ? Wanted : "";
	const size_t At = Text.find(" at ");
	if (At != std::string::npos && Text.compare(At + 4, std::string::npos, Place) == 0)
	{
		Crash(Text.substr(0, At).c_str());
	}
}

struct FAtLoading
{
	FAtLoading() { CrashAt("loading"); }
} GAtLoading;

/** As if left from a graph that is gone. */
FRDGTextureRef GetGone()
{
	alignas(FRDGTexture) static char Garbage[sizeof(FRDGTexture)];
	std::memset(Garbage, 0x5a, sizeof(Garbage));
	return reinterpret_cast<FRDGTextureRef>(Garbage);
}

/** A call that drydock has to refuse; true: the callback is to return a texture that is gone. */
bool Misuse(FRDGBuilder& GraphBuilder, const FSceneView& View, FRDGTextureRef Picture)
{
	const char* const Call = std::getenv("DRYDOCK_TEST_MISUSE");
	const auto Create = [&](EPixelFormat Format)
	{
		return GraphBuilder.CreateTexture(FRDGTextureDesc::Create2D(FIntPoint(4, 4), Format, FClearValueBinding::Black,
											  TexCreate_ShaderResource | TexCreate_RenderTargetable | TexCreate_UAV),
			TEXT("Small"));
	};
	const auto Draw = [&](FRDGTextureRef Input, FRDGTextureRef Output)
	{
		auto* Parameters = GraphBuilder.AllocParameters<FCopyRectPS::FParameters>();
		Parameters->InputTexture = Input;
		Parameters->InputSampler = TStaticSamplerState<SF_Point>::GetRHI();
		if (Output != nullptr)
		{
			Parameters->RenderTargets[0] = FRenderTargetBinding(Output, ERenderTargetLoadAction::ENoAction);
		}
		AddDrawScreenPass(GraphBuilder, RDG_EVENT_NAME("Spoilt"), View, FScreenPassTextureViewport(FIntPoint(4, 4)),
			FScreenPassTextureViewport(FIntPoint(4, 4)),
			TShaderMapRef<FCopyRectPS>(GetGlobalShaderMap(GMaxRHIFeatureLevel)), Parameters);
		if (Output != nullptr)
		{
			AddCopyTexturePass(GraphBuilder, Output, Create(Output->Desc.Format));
		}
	};
	const FRDGTextureRef Gone = GetGone();
	static TRefCountPtr<IPooledRenderTarget> Pooled; // it outlives the graph
	if (Call == nullptr)
	{
		return false;
	}
	if (Is("copy null", Call))
	{
		AddCopyTexturePass(GraphBuilder, nullptr, Picture);
	}
	else if (Is("copy gone", Call))
	{
		AddCopyTexturePass(GraphBuilder, Picture, Gone);
	}
	else if (Is("copy formats", Call))
	{
		AddCopyTexturePass(GraphBuilder, Create(PF_R8G8B8A8), Create(PF_R32_FLOAT));
	}
	else if (Is("copy mip", Call))
	{
		FRHICopyTextureInfo Info;
		Info.SourceMipIndex = 3;
		AddCopyTexturePass(GraphBuilder, Create(PF_R8G8B8A8), Create(PF_R8G8B8A8), Info);
	}
	else if (Is("copy beyond", Call))
	{
		AddCopyTexturePass(
			GraphBuilder, Create(PF_R8G8B8A8), Create(PF_R8G8B8A8), FIntPoint(2, 2), FIntPoint(0, 0), FIntPoint(3, 3));
	}
	else if (Is("draw null", Call))
	{
		FRDGTextureRef Target = Create(PF_FloatRGBA);
		Draw(nullptr, Target);
		GraphBuilder.QueueTextureExtraction(Target, &Pooled);
	}
	else if (Is("draw nowhere", Call))
	{
		Draw(Picture, nullptr);
	}
	else if (Is("draw gone", Call))
	{
		Draw(Gone, Create(PF_FloatRGBA));
	}
	else if (Is("draw parameters", Call))
	{
		AddDrawScreenPass(GraphBuilder, RDG_EVENT_NAME("Spoilt"), View, FScreenPassTextureViewport(FIntPoint(4, 4)),
			FScreenPassTextureViewport(FIntPoint(4, 4)),
			TShaderMapRef<FCopyRectPS>(GetGlobalShaderMap(GMaxRHIFeatureLevel)),
			static_cast<FCopyRectPS::FParameters*>(nullptr));
	}
	else if (Is("srv null", Call))
	{
		GraphBuilder.CreateSRV(FRDGTextureRef(nullptr));
	}
	else if (Is("srv gone", Call))
	{
		GraphBuilder.CreateSRV(Gone);
	}
	else if (Is("srv mip", Call))
	{
		GraphBuilder.CreateSRV(FRDGTextureSRVDesc::CreateForMipLevel(Picture, 9));
	}
	else if (Is("register null", Call))
	{
		GraphBuilder.RegisterExternalTexture(nullptr);
	}
	else if (Is("extract null", Call))
	{
		GraphBuilder.QueueTextureExtraction(nullptr, &Pooled);
	}
	else if (Is("clear null", Call))
	{
		AddClearRenderTargetPass(GraphBuilder, nullptr, FLinearColor::Red);
	}
	else if (Is("clear uav null", Call))
	{
		AddClearUAVPass(GraphBuilder, FRDGTextureUAVRef(nullptr), FLinearColor::Red);
	}
	else if (Is("list null", Call))
	{
		AddPass(GraphBuilder, RDG_EVENT_NAME("Spoilt"),
			[](FRHICommandListImmediate& RHICmdList) { RHICmdList.CopyTexture(nullptr, nullptr, {}); });
	}
	else if (Is("builder", Call))
	{
		FRDGBuilder Second(GraphBuilder.RHICmdList);
	}
	return Is("return gone", Call);
}

class FCrashExtension final : public FSceneViewExtensionBase
{
public:
	FCrashExtension(const FAutoRegister& AutoRegister)
		: FSceneViewExtensionBase(AutoRegister)
	{
	}

	void SetupViewFamily(FSceneViewFamily&) override {}
	void SetupView(FSceneViewFamily&, FSceneView&) override { CrashAt("SetupView"); }
	void BeginRenderViewFamily(FSceneViewFamily&) override {}

	void SubscribeToPostProcessingPass(
		EPostProcessingPass PassId, FAfterPassCallbackDelegateArray& InOutPassCallbacks, bool) override
	{
		if (PassId == EPostProcessingPass::Tonemap)
		{
			CrashAt("subscribing");
			InOutPassCallbacks.Add(FAfterPassCallbackDelegate::CreateRaw(this, &FCrashExtension::Draw));
		}
	}

protected:
	bool IsActiveThisFrame_Internal(const FSceneViewExtensionContext&) const override
	{
		CrashAt("asking");
		return true;
	}

private:
	FScreenPassTexture Draw(FRDGBuilder& GraphBuilder, const FSceneView& View, const FPostProcessMaterialInputs& Inputs)
	{
		CrashAt("callback");
		const FScreenPassTexture Picture = Inputs.GetInput(EPostProcessMaterialInput::SceneColor);
		if (Misuse(GraphBuilder, View, Picture.Texture))
		{
			return FScreenPassTexture(GetGone(), Picture.ViewRect);
		}
		AddPass(GraphBuilder, RDG_EVENT_NAME("Fatal"),
			[](FRHICommandListImmediate&)
			{
				CrashAt("pass");
				// On whichever thread comes first to the last tile.
				Drydock::ForEachTile(Drydock::FKernelTile{0, 0, 0, 64, 64, 1}, FIntPoint(8, 8),
					[](const Drydock::FKernelTile& Tile)
					{
						if (Tile.MinX == 56 && Tile.MinY == 56)
						{
							CrashAt("tile");
						}
					});
			});
		if (!Inputs.OverrideOutput.IsValid())
		{
			return Picture;
		}
		AddDrawTexturePass(GraphBuilder, View, Picture, Inputs.OverrideOutput);
		return Inputs.OverrideOutput;
	}
};

class FCrashModule : public IModuleInterface
{
public:
	void StartupModule() override
	{
		CrashAt("startup");
		Extension = FSceneViewExtensions::NewExtension<FCrashExtension>();
	}
	void ShutdownModule() override
	{
		CrashAt("shutdown");
		Extension.Reset();
	}

private:
	TSharedPtr<FCrashExtension, ESPMode::ThreadSafe> Extension;
};

} // namespace

IMPLEMENT_MODULE(FCrashModule, CrashPlugin)
