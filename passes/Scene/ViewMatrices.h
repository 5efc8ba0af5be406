// FViewMatrices: the matrices of a view's camera, and what follows from them. Source: engine file SceneView.h.
#pragma once

#include "CoreMinimal.h"

/**
 * Row vectors are multiplied from the left: World * View * Projection = Clip. View space is x right, y up, z forward,
 * in cm. Clip depth is reversed: 1 at the near plane, 0 far away. Translated world is the world moved by
 * GetPreViewTranslation(), so that the camera is at its origin: matrices of it lose no precision far from the world's.
 * The values are those of the View uniform buffer, which has them as floats.
 */
struct DRYDOCK_API FViewMatrices
{
	struct FMinimalInitializer
	{
		/** World to view axes, without a translation. */
		FMatrix ViewRotationMatrix = FMatrix::Identity;
		FMatrix ProjectionMatrix = FMatrix::Identity;
		FVector ViewOrigin = FVector(0.0, 0.0, 0.0);
		/** Pixels. */
		FIntRect ConstrainedViewRect = FIntRect(0, 0, 2, 2);
	};

	/** A camera at the origin whose matrices are all the identity. */
	FViewMatrices();
	explicit FViewMatrices(const FMinimalInitializer& Initializer);

	/** Moves and turns the camera. */
	void UpdateViewMatrix(const FVector& ViewLocation, const FRotator& ViewRotation);
	/** Adds a jitter, in clip space, to the projection. A check if there is one. */
	void HackAddTemporalAAProjectionJitter(const FVector2D& Jitter);
	void HackRemoveTemporalAAProjectionJitter();

	const FMatrix& GetProjectionMatrix() const { return ProjectionMatrix; }
	const FMatrix& GetInvProjectionMatrix() const { return InvProjectionMatrix; }
	const FMatrix& GetProjectionNoAAMatrix() const { return ProjectionNoAAMatrix; }
	const FMatrix& GetViewMatrix() const { return ViewMatrix; }
	const FMatrix& GetInvViewMatrix() const { return InvViewMatrix; }
	const FMatrix& GetViewProjectionMatrix() const { return ViewProjectionMatrix; }
	const FMatrix& GetInvViewProjectionMatrix() const { return InvViewProjectionMatrix; }
	const FMatrix& GetTranslatedViewMatrix() const { return TranslatedViewMatrix; }
	const FMatrix& GetInvTranslatedViewMatrix() const { return InvTranslatedViewMatrix; }
	/** The view matrix of translated world whatever overrides it; here nothing does. */
	const FMatrix& GetOverriddenTranslatedViewMatrix() const { return TranslatedViewMatrix; }
	const FMatrix& GetOverriddenInvTranslatedViewMatrix() const { return InvTranslatedViewMatrix; }
	const FMatrix& GetTranslatedViewProjectionMatrix() const { return TranslatedViewProjectionMatrix; }
	const FMatrix& GetInvTranslatedViewProjectionMatrix() const { return InvTranslatedViewProjectionMatrix; }
	/** cm; what a point of the world is moved by to be one of translated world: minus the camera's place. */
	const FVector& GetPreViewTranslation() const { return PreViewTranslation; }
	const FVector& GetViewOrigin() const { return ViewOrigin; }
	/** Pixels that something 1 cm wide covers at a distance of 1 cm, horizontally or vertically, whichever are more. */
	float GetScreenScale() const { return ScreenScale; }
	FVector2D GetTemporalAAJitter() const { return TemporalAAJitter; }

	FMatrix ComputeProjectionNoAAMatrix() const;
	FMatrix ComputeInvProjectionNoAAMatrix() const { return ComputeProjectionNoAAMatrix().Inverse(); }
	bool IsPerspectiveProjection() const { return ProjectionMatrix.M[3][3] < 1.0; }
	/** cm before the camera. */
	float ComputeNearPlane() const;
	/** Radians, horizontal and vertical. */
	FVector2D ComputeHalfFieldOfViewPerAxis() const;

	bool operator==(const FViewMatrices&) const = default;

private:
	void RecomputeDerivedMatrices();

	FMatrix ProjectionMatrix;
	FMatrix ProjectionNoAAMatrix;
	FMatrix InvProjectionMatrix;
	FMatrix ViewMatrix;
	FMatrix InvViewMatrix;
	FMatrix ViewProjectionMatrix;
	FMatrix InvViewProjectionMatrix;
	FMatrix TranslatedViewMatrix;
	FMatrix InvTranslatedViewMatrix;
	FMatrix TranslatedViewProjectionMatrix;
	FMatrix InvTranslatedViewProjectionMatrix;
	FVector PreViewTranslation;
	FVector ViewOrigin;
	FVector2D TemporalAAJitter;
	FIntPoint RectSize;
	float ScreenScale = 1.0f;
};
