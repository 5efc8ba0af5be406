// Everyday calls that plugins make on views, families, actors and Core. That each compiles is the test; what they give
// is tested elsewhere.
#include "Async/Async.h"
#include "Async/TaskGraphInterfaces.h"
#include "CoreMinimal.h"
#include "GameFramework/Actor.h"
#include "Logging/StructuredLog.h"
#include "Math/Float16Color.h"
#include "Math/Vector2DHalf.h"
#include "Misc/App.h"
#include "Misc/TVariant.h"
#include "PackedNormal.h"
#include "PostProcess/PostProcessWeightedSampleSum.h"
#include "PostProcess/PostProcessing.h"
#include "RenderCommandFence.h"
#include "SceneRendering.h"

namespace
{

FAutoConsoleCommandWithWorldAndArgs GEverydayCommand(TEXT("Everyday.Command"), TEXT("Help"),
	FConsoleCommandWithWorldAndArgsDelegate::CreateLambda([](const TArray<FString>&, UWorld*) {}));

[[maybe_unused]] void CallViews(
	FRDGBuilder& GraphBuilder, const FSceneView& View, const FPostProcessMaterialInputs& Inputs)
{
	const FViewInfo& Info = static_cast<const FViewInfo&>(View);
	const FViewMatrices& Matrices = View.ViewMatrices;
	const FMatrix44f ToClip(Matrices.GetTranslatedViewProjectionMatrix());
	const FMatrix44f FromClip(Matrices.GetInvTranslatedViewProjectionMatrix());
	const FVector3f Origin(Matrices.GetViewOrigin() + Matrices.GetPreViewTranslation());
	const FMatrix Last = Info.PrevViewInfo.ViewMatrices.GetViewProjectionMatrix();
	const FVector2f Jitter(Info.TemporalJitterPixels);
	const FVector Directions = View.GetViewDirection() + View.GetViewRight() + View.GetViewUp();
	const bool bPlain = View.IsPerspectiveProjection() && View.ViewActor == nullptr && !View.bIsOfflineRender &&
						!View.bIsSceneCaptureCube && View.StereoViewIndex == INDEX_NONE && View.PlayerIndex < 1;
	const float Degrees = View.FOV + static_cast<float>(View.ViewRotation.Yaw) + View.GetLastEyeAdaptationExposure();
	const FIntPoint Size = Info.GetSecondaryViewRectSize();
	const FSceneViewFamily& Family = *View.Family;
	const FViewFamilyInfo& FamilyInfo = static_cast<const FViewFamilyInfo&>(Family);
	const bool bGame = Family.EngineShowFlags.Game && Family.EngineShowFlags.Lighting &&
					   !Family.EngineShowFlags.Wireframe && Family.EngineShowFlags.Rendering &&
					   Family.SceneCaptureSource == SCS_FinalToneCurveHDR;
	const float Exposure = Info.CachedViewUniformShaderParameters->PreExposure;
	FGaussianBlurInputs Blur;
	Blur.Filter = Inputs.GetInput(EPostProcessMaterialInput::SceneColor);
	Blur.Filter = FScreenPassTextureSlice::CreateFromScreenPassTexture(GraphBuilder, FScreenPassTexture());
	const FScreenPassTexture Copy = FScreenPassTexture::CopyFromSlice(
		GraphBuilder, Inputs.GetInput(EPostProcessMaterialInput::SceneColor), Inputs.OverrideOutput);
	UE_LOGFMT(LogTemp, Verbose, "{0} {1}", bPlain && bGame, Degrees + Exposure + Origin.X + Jitter.X);
	UE_LOGFMT(LogTemp, Verbose, "{Key}", ("Key", View.GetViewKey()));
	(void)FamilyInfo.GetSceneTextures();
	(void)(ToClip == FromClip || Last.M[0][0] == 0.0 || Directions.X == 0.0 || Size.X == 0 || Copy.IsValid());
}

[[maybe_unused]] void CallCore(AActor& Actor)
{
	FRenderCommandFence Fence;
	Fence.BeginFence();
	Fence.Wait();
	Actor.SetActorHiddenInGame(!Actor.IsHidden());
	const FLinearColor Colors[] = {FColor::Cyan, FColor::Magenta, FColor::Orange, FColor::Purple};
	const FRandomStream Stream(FMath::RandRange(1, 5));
	const FTransform Transform(FRotator(0, 90, 0), Stream.VRand() * FApp::GetDeltaTime());
	const FPlane Plane(Transform.GetLocation(), FVector::UpVector);
	const FBoxSphereBounds Bounds(FBox(FVector::ZeroVector, FVector::OneVector));
	const FFloat16Color Half(Colors[0]);
	const FVector2DHalf Pair(FVector2D(1.0, 2.0));
	const FPackedNormal Normal(FVector3f(0, 0, 1));
	TVariant<int32, FName> Variant(TInPlaceType<FName>(), FName(TEXT("Name"), 3));
	AsyncTask(ENamedThreads::GameThread, [Text = FText::FromString(FDateTime::Now().ToString())] { (void)Text; });
	(void)(Plane.PlaneDot(Bounds.Origin) + static_cast<double>(Half.R.GetFloat()) + FVector2D(Pair).X +
		   Normal.ToFVector().Z + Variant.Get<FName>().GetNumber() + static_cast<double>(Actor.GetActorTimeDilation()));
}

} // namespace
