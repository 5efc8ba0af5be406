// Derives a view's matrices.
#include "ViewMatrices.h"

FViewMatrices::FViewMatrices()
	: FViewMatrices(FMinimalInitializer())
{
}

FViewMatrices::FViewMatrices(const FMinimalInitializer& Initializer)
	: ProjectionMatrix(Initializer.ProjectionMatrix)
	, ProjectionNoAAMatrix(Initializer.ProjectionMatrix)
	, TranslatedViewMatrix(Initializer.ViewRotationMatrix)
	, ViewOrigin(Initializer.ViewOrigin)
	, RectSize(Initializer.ConstrainedViewRect.Size())
{
	RecomputeDerivedMatrices();
}

void FViewMatrices::UpdateViewMatrix(const FVector& ViewLocation, const FRotator& ViewRotation)
{
	// World axes are x forward, y right, z up.
	const FMatrix Axes(FVector(0, 0, 1), FVector(1, 0, 0), FVector(0, 1, 0), FVector(0, 0, 0));
	ViewOrigin = ViewLocation;
	TranslatedViewMatrix = FInverseRotationMatrix(ViewRotation) * Axes;
	RecomputeDerivedMatrices();
}

void FViewMatrices::HackAddTemporalAAProjectionJitter(const FVector2D& Jitter)
{
	check(TemporalAAJitter == FVector2D());
	TemporalAAJitter = Jitter;
	ProjectionMatrix.M[2][0] += Jitter.X;
	ProjectionMatrix.M[2][1] += Jitter.Y;
	RecomputeDerivedMatrices();
}

void FViewMatrices::HackRemoveTemporalAAProjectionJitter()
{
	ProjectionMatrix = ComputeProjectionNoAAMatrix();
	TemporalAAJitter = FVector2D();
	RecomputeDerivedMatrices();
}

FMatrix FViewMatrices::ComputeProjectionNoAAMatrix() const
{
	FMatrix Result = ProjectionMatrix;
	Result.M[2][0] -= TemporalAAJitter.X;
	Result.M[2][1] -= TemporalAAJitter.Y;
	return Result;
}

float FViewMatrices::ComputeNearPlane() const
{
	// The depth z at which clip z = clip w.
	return static_cast<float>(
		(ProjectionMatrix.M[3][3] - ProjectionMatrix.M[3][2]) / (ProjectionMatrix.M[2][2] - ProjectionMatrix.M[2][3]));
}

FVector2D FViewMatrices::ComputeHalfFieldOfViewPerAxis() const
{
	return FVector2D(std::atan(1.0 / ProjectionMatrix.M[0][0]), std::atan(1.0 / ProjectionMatrix.M[1][1]));
}

void FViewMatrices::RecomputeDerivedMatrices()
{
	const FTranslationMatrix ToWorld(ViewOrigin);
	PreViewTranslation = ViewOrigin * -1.0;
	InvProjectionMatrix = ProjectionMatrix.Inverse();
	InvTranslatedViewMatrix = TranslatedViewMatrix.GetTransposed();
	ViewMatrix = FTranslationMatrix(PreViewTranslation) * TranslatedViewMatrix;
	InvViewMatrix = InvTranslatedViewMatrix * ToWorld;
	ViewProjectionMatrix = ViewMatrix * ProjectionMatrix;
	InvViewProjectionMatrix = InvProjectionMatrix * InvViewMatrix;
	TranslatedViewProjectionMatrix = TranslatedViewMatrix * ProjectionMatrix;
	InvTranslatedViewProjectionMatrix = InvProjectionMatrix * InvTranslatedViewMatrix;
	ScreenScale = static_cast<float>(
		FMath::Max(0.5 * RectSize.X * ProjectionMatrix.M[0][0], 0.5 * RectSize.Y * ProjectionMatrix.M[1][1]));
}
