// The camera of a rendered frame, and what shaders read of it. Matrices: engine
// SceneView.h, row vectors, view space x right, y up, z forward.
#pragma once

#include "CoreMinimal.h"
#include "SceneView.h"

#include <optional>
#include <string>

namespace Drydock
{

/** Near plane of the device depth that is made of a scene file's depth, cm. */
constexpr double SceneNearPlane = 10.0;

/** In the engine's axes: cm, left-handed, Z up; degrees. */
struct FSceneCamera
{
	FVector Location = FVector(0.0, 0.0, 0.0);
	double Pitch = 0.0;
	double Yaw = 0.0;
	double Roll = 0.0;
	double HorizontalFov = 90.0;
	std::optional<double> FocalLength;       // pixels of the picture; in place of HorizontalFov
	std::optional<FVector2D> PrincipalPoint; // pixels of the picture; its centre by default
	/** Pixels of the picture: how far right and down it is drawn of where it is without jitter; not set: the file's
	 * header has none. */
	std::optional<FVector2D> Jitter;
	bool bCut = false; // nothing of the frame before is to be seen
};

/** Reads a drydock:camera_json text; empty when it is none. */
DRYDOCK_API std::optional<FSceneCamera> ReadSceneCamera(const std::string& Json);

/** Seconds from one frame to the next, of such a text; empty when it has none that is above 0. */
DRYDOCK_API std::optional<double> ReadSceneDeltaTime(const std::string& Json);

/** The camera's jitter in clip space, of a view that covers Rect. */
DRYDOCK_API FVector2D MakeClipJitter(const FSceneCamera& Camera, const FIntRect& Rect);

/** View to clip space, without jitter, of a view that covers Rect (pixels of a picture of PictureExtent). Device depth
 * is SceneNearPlane / z: 1 at the near plane, 0 at infinity. */
DRYDOCK_API FMatrix MakeProjection(const FSceneCamera& Camera, FIntPoint PictureExtent, const FIntRect& Rect);

/** z, w of the transform by which shaders turn device depth into centimetres: 1 / (DeviceZ * z - w). Depth 0 gives 1e8
 * cm, not infinity, as in the engine. */
DRYDOCK_API FVector4f GetInvDeviceZToWorldZTransform();

/** Device depth that ConvertFromDeviceZ turns back into Depth cm; never below 0. */
DRYDOCK_API float MakeDeviceDepth(double Depth);

/** The projection of a view of Rect; its view rectangle is the same pixels in the scene textures, BufferRect. */
DRYDOCK_API FSceneViewProjectionData MakeProjectionData(
	const FSceneCamera& Camera, FIntPoint PictureExtent, const FIntRect& Rect, const FIntRect& BufferRect);

/** Fills matrices, vectors and depth transform; ClipToPrevClip and the members of the previous frame are those of a
 * camera that stands still. */
DRYDOCK_API void SetCameraParameters(
	const FSceneViewProjectionData& ProjectionData, FViewUniformShaderParameters& Parameters);

/** Fills the members that hold the camera of the previous frame. */
DRYDOCK_API void SetPrevCameraParameters(
	const FSceneViewProjectionData& Previous, FViewUniformShaderParameters& Parameters);

/** The matrix that projects a point of this frame's clip space to last frame's, for a static world; exactly the
 * identity if the camera did not move. */
DRYDOCK_API FMatrix44f MakeClipToPrevClip(
	const FSceneViewProjectionData& Current, const FSceneViewProjectionData& Previous);

} // namespace Drydock
